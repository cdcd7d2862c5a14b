#pragma once

#include <optional>

#include "render/grid_layout.h"
#include "render/shading/pixel_shader.h"
#include "render/software/screen_grid.h"

namespace seaway::render {

/// What turns a pixel's distance into slopes: the grid's, packed for one fetch a vertex, and where
/// a place lies in the grid.
class SeaSlopes {
 public:
  void fill(const SeaGrid& grid, const GridLayout& layout);
  std::size_t memoryBytes() const {
    return packed_.capacity() * sizeof(std::uint32_t) +
           (rowStart_.capacity() + rowStep_.capacity()) * sizeof(float);
  }

  /// Fills kinds, distances and slopes of a span from 1/axial distances, for rays set before.
  /// The surface is `underside` where `cameraIsUnderWater`, else `water`.
  void fillSpan(const float* inverse, const Camera& camera, bool cameraIsUnderWater,
                PixelSpan& span) const;

  /// Slopes are kept in steps of 2⁻¹³ up to this.
  static constexpr float steepest = 4.0f;

 private:
  Projector::GridFromPlane gridFromPlane_;
  std::optional<RingLaw> rings_;
  glm::ivec2 size_{0};
  std::vector<std::uint32_t> packed_;      // slope x in the low 16 bits, y in the high ones
  std::vector<float> rowStart_, rowStep_;  // m across from the grid's foot; to the next column
  const float *missing_ = nullptr, *missingWakes_ = nullptr;
  const std::uint32_t* cover_ = nullptr;  // null: nothing lies on the water
};

}  // namespace seaway::render
