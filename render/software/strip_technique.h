#pragma once

#include <optional>
#include <vector>

#include "render/hollows.h"
#include "render/lighting_decision.h"
#include "render/local_light.h"
#include "render/render_technique.h"
#include "render/shadow_maps.h"
#include "render/shore.h"
#include "render/software/object_edges.h"
#include "render/software/object_triangles.h"
#include "render/software/raster.h"
#include "render/terrain/terrain_in_view.h"
#include "render/waterline.h"

namespace seaway::render {

/// A technique that draws on the processor alone, in strips of the picture that threads share:
/// objects, shading and smoothing. How the sea gets into the strips is left to those who derive.
class StripTechnique : public RenderTechnique {
 public:
  void drawInto(const View& view, Frame& frame) final;

 protected:
  /// Gets ready to draw the sea; false where there is none. Notes the variant and what is known of
  /// vertices in `stats`.
  virtual bool placeSea(const View& view, FrameStats& stats) = 0;
  /// Puts 1/axial distance of the sea into a cleared strip. Called from several threads.
  virtual void rasterSea(const View& view, Strip& strip) = 0;
  /// Fills kind, distance, slopes and height of a span of row `row` from pixel `first` on, whose
  /// rays are set. Called from several threads.
  virtual void fillSeaSpan(const View& view, const float* inverse, int row, int first,
                           bool underWater, PixelSpan& span) const = 0;
  virtual std::size_t seaMemoryBytes() const = 0;

  /// The frame's objects, for a sea that is drawn over a scene.
  const ObjectTriangles& objects() const { return objects_; }
  /// The frame's waterline, once the sea is placed.
  const Waterline& waterline() const { return waterline_; }

 private:
  /// A row of the picture to be shaded.
  struct ShadedRow {
    const View& view;
    const ShadingConstants& constants;
    const Shown& shown;
    int row;
  };
  void raster(const View& view, const Shown& shown);
  void shade(const View& view, const Shown& shown, const Lighting& lighting, Frame& frame);
  ShadingSources sourcesFor(const ShadingConstants& constants) const;
  void shadeRow(const ShadedRow& r, Frame& frame);
  void softenObjects(const ShadedRow& r, Frame& frame);
  void fillSpan(const ShadedRow& r, int first, const float* sea, const std::uint32_t* which,
                const float* objects, PixelSpan& span) const;
  void colour(const ShadedRow& r, const PixelSpan& span, std::uint8_t* rgb,
              glm::vec3* radiance) const;
  void storeLabels(const ShadedRow& r, const PixelSpan& span, const std::uint32_t* which,
                   std::size_t at, Frame& frame) const;
  void prepareTerrain(const View& view, Shown& shown);

  ObjectTriangles objects_;
  PixelBox objectBox_;  // of what of them is in the picture
  std::vector<Strip> strips_;
  std::vector<ObjectEdges> edges_;        // of each strip
  std::vector<std::uint8_t> isSoftened_;  // of each pixel, where objects are shown
  std::optional<SkyDome> sky_;
  std::vector<SceneObject> kept_;
  ShadowMaps shadows_;
  Waterline waterline_;
  LocalLight local_;
  std::optional<Shore> shore_;  // of this frame
  TerrainInView terrain_;
  TerrainInView::Triangles ground_;    // of this frame
  std::vector<Strip> groundStrips_;    // empty where no ground is shown
  std::vector<PlacedHollow> hollows_;  // of this frame
};

}  // namespace seaway::render
