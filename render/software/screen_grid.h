#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "render/camera.h"
#include "render/sea_grid.h"
#include "render/software/screen_triangle.h"

namespace seaway::render {

/// Quads side by side in a row of the grid that are drawn together.
inline constexpr int quadsPerBatch = 16;

/// The sea's grid projected to the picture, with the extent of each batch of quads.
class ScreenGrid {
 public:
  void fill(const SeaGrid& grid, const Camera& camera);

  glm::ivec2 size() const { return size_; }
  int batchesPerRow() const { return batchesPerRow_; }

  /// Pixel position and 1/axial distance of each vertex; the latter 0 for one nearer than the near
  /// plane. Arrays are readable 16 elements past their end.
  const float* x() const { return x_.data(); }
  const float* y() const { return y_.data(); }
  const float* inverse() const { return inverse_.data(); }

  /// What a batch of quads covers.
  struct Extent {
    float top, bottom;  ///< pixel rows; empty (top > bottom) where there is nothing to draw
  };
  const Extent& extent(int row, int batch) const {
    return extents_[static_cast<std::size_t>(row) * batchesPerRow_ + batch];
  }

  /// Batches that reach behind the camera or far beside the picture, as single triangles.
  const std::vector<ScreenTriangle>& clipped() const { return clipped_; }

  std::size_t memoryBytes() const;

 private:
  enum class Fate { drawn, empty, clipped };
  Fate extentOf(int row, int batch, glm::ivec2 picture, Extent& extent) const;
  void clip(const SeaGrid& grid, const ScreenProjection& projection, int row, int batch);

  glm::ivec2 size_{0};
  int batchesPerRow_ = 0;
  std::vector<float> x_, y_, inverse_;
  std::vector<Extent> extents_;
  std::vector<std::uint8_t> isClipped_;  // of each batch
  std::vector<ScreenTriangle> clipped_;
};

}  // namespace seaway::render
