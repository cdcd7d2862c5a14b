#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "render/lighting_decision.h"
#include "render/pixel_box.h"
#include "render/shading/pixel_shader.h"
#include "render/software/raster.h"
#include "render/terrain/terrain_lod.h"
#include "render/terrain/terrain_skin.h"

namespace seaway::render {

/// Whether any of a map, or the sea bed that it ends in, may lie in a camera's view.
bool mapMayShow(const TerrainMap& map, const Camera& camera);

/// Ground and sea bed of a view, on every way of drawing. A technique keeps one of these: levels of
/// detail and skin are made when a terrain is first in view.
class TerrainInView {
 public:
  /// Decides on the `terrain` effect with the view's ledger and selects what is seen directly.
  void prepare(const View& view, const Shown& shown);

  /// Whether any ground or sea bed may be in the picture, by way of the water too.
  bool isShown() const { return map_ != nullptr; }
  /// Triangles seen directly: three corners each relative to the camera, m.
  std::span<const glm::vec3> corners() const { return corners_; }

  const TerrainMap& map() const { return *map_; }
  const TerrainSkin& skin() const { return *skin_; }
  float wetHeight() const { return wetHeight_; }

  std::size_t memoryBytes() const;

  /// Triangles in the picture, for the processor.
  class Triangles {
   public:
    void clear() { triangles_.clear(); }
    bool empty() const { return triangles_.empty(); }
    void fill(std::span<const glm::vec3> corners, const Camera& camera);
    void raster(Strip& strip) const;
    PixelBox boxIn(glm::ivec2 picture) const { return boxOf(triangles_, picture); }
    std::pair<float, float> axialRange() const { return axialRangeOf(triangles_); }
    std::size_t memoryBytes() const { return triangles_.capacity() * sizeof(ScreenTriangle); }

   private:
    std::vector<ScreenTriangle> triangles_;
  };

  /// What the water mirrors of it, or shows of its bed: to where `extinction` (1/m) leaves a
  /// hundredth.
  void fill(const Camera& camera, TerrainSide side, float extinction, Triangles& triangles) const;

  /// Makes ground of pixels of a span where it is nearer than what is there: `inverse` its 1/axial
  /// distance, 0 where there is none. Objects must be in the span already.
  void fillSpan(const Camera& camera, const float* inverse, TerrainSide side,
                PixelSpan& span) const;

 private:
  void decide(const View& view, bool called, const char* reason);

  std::shared_ptr<const TerrainMap> kept_;  // what lod_ and skin_ are of
  const TerrainMap* map_ = nullptr;         // null: not in this frame
  std::optional<TerrainLod> lod_;
  std::optional<TerrainSkin> skin_;
  std::vector<glm::vec3> corners_;
  float wetHeight_ = 0.0f, pixelAngle_ = 0.0f;
  double heightBound_ = 0.0;
};

}  // namespace seaway::render
