#pragma once

#include <optional>

#include "render/camera.h"
#include "render/grid_layout.h"
#include "render/sea_grid.h"
#include "render/software/raster.h"

namespace seaway::render {

struct PixelSpan;

/// On which side of the water a picture's rays begin.
enum class RayStart { above, below, either };

/// Rays against a height map on rings about the camera's foot, a vector of pixels at a time.
class SeaMarch {
 public:
  /// Refers to `grid`, filled for `camera` from a layout with rings. No height passes ± `bound` m.
  void fill(const SeaGrid& grid, const GridLayout& layout, const Camera& camera, double bound,
            int steps);

  /// Puts 1/axial distance of the sea into a strip: from what `scene` holds (1/axial distance of
  /// the scene's objects, 0 where there is none; null: there are none) or where the ray leaves the
  /// waves' bounds, towards the viewer in steps that shrink evenly, to the last of them between
  /// which the ray leaves the water; there by three false positions.
  void march(const Strip* scene, RayStart start, Strip& strip) const;

  /// Slopes of a span, whose kinds and distances are set, by central differences of the map over
  /// its own spacing: the normal (W − E, 2d, S − N) of four neighbours.
  void fillSlopes(PixelSpan& span) const;

 private:
  glm::ivec2 size_{0};
  RingLaw law_;
  const float* heights_ = nullptr;
  Camera camera_;
  double bound_ = 0.0;
  int steps_ = 16;
};

}  // namespace seaway::render
