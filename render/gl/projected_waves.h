#pragma once

#include <optional>
#include <span>
#include <vector>

#include "render/gl/cover_map.h"
#include "render/gl/gpu_clock.h"
#include "render/gl/outline_buffers.h"
#include "render/gl/sea_geometry_pass.h"
#include "render/gl/stamp_map.h"
#include "render/gl/stamp_pass.h"
#include "render/gl/wake_stamp_pass.h"
#include "render/gl/wave_map.h"

namespace seaway::render {

/// What the variants with heights from the graphics card share: the field's twin around the
/// camera's foot, the grid's rows, and the wave map over them, stamps added.
class ProjectedWaves {
 public:
  /// `way` as the context is quicker: compute shaders on hardware, fragment shaders in software.
  ProjectedWaves();

  /// Fills the map for a grid of `size`, wakes of the view's water and `stamps` added. Neither
  /// costs anything while there are none.
  void fill(const View& view, const Projector& projector, glm::ivec2 size,
            std::span<const Stamp> stamps = {});

  /// Tells a program where the view's sea has water; null outlines cost nothing.
  void useOutline(const GlProgram& program, const View& view) {
    outline_.use(program, view.water->sharedOutline(), view.camera);
  }

  /// Tells a program what lies on the water, at the map's texels: `coverMap` on texture unit 2.
  void useCover(const GlProgram& program) const;

  /// Splashes and the like, as added to the map; 0 while there are none.
  GLuint extras() const { return coverMap_.extras(); }

  const WaveMap& map() const { return map_; }
  /// Wakes and stamps alone, as added to the map; 0 while there are none.
  GLuint stamps() const { return stampMap_ ? stampMap_->texture() : GLuint{0}; }
  std::span<const TwinRow> rows() const { return rows_; }

  /// See SeaGeometryPass::gpuMs.
  std::vector<std::pair<std::string, double>> gpuMs() { return clock_.collect(); }

  std::size_t memoryBytes() const;

 private:
  void addStamps(std::span<const Stamp> stamps, glm::dvec2 foot, int columns);

  GlVertexArray noVertices_;
  WaveMap map_;
  CoverMap coverMap_;
  OutlineBuffers outline_;
  std::optional<StampMap> stampMap_;
  std::optional<StampPass> stampPass_;
  std::optional<WakeStampPass> wakePass_;
  WakesInView wakes_;
  std::vector<TwinRow> rows_;
  GpuClock clock_;
};

}  // namespace seaway::render
