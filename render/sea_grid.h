#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "render/camera.h"
#include "render/grid_layout.h"
#include "render/wakes_in_view.h"
#include "surface/water_surface.h"

namespace seaway::render {

class Surf;

/// A grid's vertices: places, heights and slopes, one array each, row by row from the
/// nearest. All that the grid cannot carry is left out as BandLimit says, by the row.
class SeaGrid {
 public:
  /// Fills the grid from `water`; rows are shared among threads, memory is reused between calls.
  /// Rings are sampled only where the camera may see them, with waves up to `bound` m. `surf`: null
  /// where nothing breaks on a shore.
  void fill(const SurfaceAtTime& water, const Camera& camera, const GridLayout& layout,
            double bound = 0.0, const Surf* surf = nullptr);

  glm::ivec2 size() const { return size_; }
  std::size_t vertexCount() const { return static_cast<std::size_t>(size_.x) * size_.y; }

  /// Relative to the camera, sea-plane axes, on the curved sea, m.
  const std::vector<float>& x() const { return x_; }
  const std::vector<float>& y() const { return y_; }
  const std::vector<float>& z() const { return z_; }
  /// Of the waves that the grid carries: height above still water, m, and slope.
  const std::vector<float>& height() const { return height_; }
  const std::vector<float>& slopeX() const { return slopeX_; }
  const std::vector<float>& slopeY() const { return slopeY_; }
  /// Mean-square slope that a row does not carry.
  const std::vector<float>& missingSlope() const { return missingSlope_; }

  /// What lies on the water at each vertex, foam, smoothed water and oil in the low three bytes;
  /// empty: nothing anywhere.
  const std::vector<std::uint32_t>& cover() const { return cover_; }

  /// Mean-square slope of wakes that a vertex does not carry, beside its row's; empty: none.
  const std::vector<float>& missingWakes() const { return missingWakes_; }

  /// Whether a batch of `batch` quads of a row, between it and the next, may show water: false only
  /// where the sea has an outline and none of the batch is inside, or where rings lie out of view.
  /// Vertices of none that may, and those outside the outline, lie at still-water level.
  static constexpr int batch = 16;
  bool mayShow(int row, int batchIndex) const {
    return shown_.empty() || shown_[static_cast<std::size_t>(row) * batches() + batchIndex] != 0;
  }

  /// Largest |height| of all vertices, m.
  double largestHeight() const { return largestHeight_; }
  /// Vertices inside the camera's frustum.
  std::size_t verticesInFrustum(const Camera& camera) const;

  std::size_t memoryBytes() const;

 private:
  int batches() const { return (size_.x - 2) / batch + 1; }
  void hideDry(const WaterOutline& outline, const Camera& camera, const GridLayout& layout);
  bool isAsked(int row, int column) const;
  double fillRow(const SurfaceAtTime& water, const Camera& camera, const GridLayout& layout,
                 int row);
  double fillPiece(const SurfaceAtTime& water, const Camera& camera, const GridLayout& layout,
                   int row, int first, int count);
  void addWakes(std::span<const double> x, std::span<const double> y, double spacing,
                std::size_t at, const FieldAtTime::Arrays& waves);

  glm::ivec2 size_{0};
  std::vector<float> x_, y_, z_, height_, slopeX_, slopeY_, missingSlope_, missingWakes_;
  std::vector<std::uint32_t> cover_;
  WakesInView wakes_;
  std::vector<double> rowLargest_;
  std::vector<std::uint8_t> shown_;  // one a batch; empty: all
  double largestHeight_ = 0.0;
  const Surf* surf_ = nullptr;  // while it is filled
};

}  // namespace seaway::render
