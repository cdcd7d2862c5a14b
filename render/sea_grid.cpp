#include "render/sea_grid.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>

#include "surface/curvature.h"

namespace seaway::render {
namespace {

constexpr int chunk = 256;  // columns sampled at a time

/// Heights and slopes of a chunk of a row.
struct Waves {
  std::array<float, chunk> height, slopeX, slopeY;

  FieldAtTime::Arrays arrays(int count) {
    const auto part = [&](std::array<float, chunk>& all) { return std::span(all.data(), count); };
    return {part(height), part(slopeX), part(slopeY), {}};
  }
};

}  // namespace

void SeaGrid::fill(const SurfaceAtTime& water, const Camera& camera, const GridLayout& layout) {
  size_ = layout.size;
  for (auto* values : {&x_, &y_, &z_, &height_, &slopeX_, &slopeY_}) values->resize(vertexCount());
  missingSlope_.resize(size_.y);
  rowLargest_.resize(size_.y);
  tbb::parallel_for(0, size_.y, [&](int row) {
    rowLargest_[row] = fillRow(water, camera, layout.rows[row], row);
  });
  largestHeight_ = *std::max_element(rowLargest_.begin(), rowLargest_.end());
}

double SeaGrid::fillRow(const SurfaceAtTime& water, const Camera& camera,
                        const GridLayout::Row& layout, int row) {
  const auto& [start, step, plan] = layout;
  missingSlope_[row] = static_cast<float>(plan.missingSlope);
  const bool fades = plan.weight > 0.0;
  const auto weight = static_cast<float>(plan.weight);
  std::array<double, chunk> x, y;
  Waves waves, fading;
  double largest = 0.0;
  for (int first = 0; first < size_.x; first += chunk) {
    const int count = std::min(chunk, size_.x - first);
    for (int i = 0; i < count; ++i) {
      x[i] = camera.position.x + start.x + step.x * (first + i);
      y[i] = camera.position.y + start.y + step.y * (first + i);
    }
    const std::span<const double> xs(x.data(), count), ys(y.data(), count);
    water.waves().sample(xs, ys, waves.arrays(count), {.shortestWavelength = plan.keptWavelength});
    if (fades) {
      water.waves().sample(xs, ys, fading.arrays(count),
                           {.shortestWavelength = plan.fadingWavelength});
    }
    const std::size_t at = static_cast<std::size_t>(row) * size_.x + first;
    for (int i = 0; i < count; ++i) {
      float height = waves.height[i], slopeX = waves.slopeX[i], slopeY = waves.slopeY[i];
      if (fades) {
        height += weight * (fading.height[i] - height);
        slopeX += weight * (fading.slopeX[i] - slopeX);
        slopeY += weight * (fading.slopeY[i] - slopeY);
      }
      // Where the field has no answer the sea is drawn still: a hole would look like sky.
      if (!std::isfinite(height)) height = slopeX = slopeY = 0.0f;
      const glm::dvec2 base = start + step * static_cast<double>(first + i);
      largest = std::max(largest, static_cast<double>(std::abs(height)));
      x_[at + i] = static_cast<float>(base.x);
      y_[at + i] = static_cast<float>(base.y);
      z_[at + i] = static_cast<float>(height - seaDrop(glm::length(base)) - camera.position.z);
      height_[at + i] = height;
      slopeX_[at + i] = slopeX;
      slopeY_[at + i] = slopeY;
    }
  }
  return largest;
}

std::size_t SeaGrid::verticesInFrustum(const Camera& camera) const {
  const double halfHeight = std::tan(0.5 * camera.verticalFieldOfView);
  const glm::vec3 forward(camera.forward());
  const glm::vec3 right(-camera.left() / (halfHeight * camera.aspectRatio()));
  const glm::vec3 up(camera.up() / halfHeight);
  const auto nearest = static_cast<float>(camera.nearDistance);
  return tbb::parallel_reduce(
      tbb::blocked_range<std::size_t>(0, vertexCount(), 4096), std::size_t{0},
      [&](const tbb::blocked_range<std::size_t>& range, std::size_t found) {
        int inside = 0;
        for (std::size_t i = range.begin(); i != range.end(); ++i) {
          const float axial = x_[i] * forward.x + y_[i] * forward.y + z_[i] * forward.z;
          const float across = std::abs(x_[i] * right.x + y_[i] * right.y + z_[i] * right.z);
          const float upwards = std::abs(x_[i] * up.x + y_[i] * up.y + z_[i] * up.z);
          inside += (axial >= nearest) & (across <= axial) & (upwards <= axial);
        }
        return found + static_cast<std::size_t>(inside);
      },
      std::plus<>());
}

std::size_t SeaGrid::memoryBytes() const {
  return (x_.capacity() + y_.capacity() + z_.capacity() + height_.capacity() +
          slopeX_.capacity() + slopeY_.capacity() + missingSlope_.capacity()) *
             sizeof(float) +
         rowLargest_.capacity() * sizeof(double);
}

}  // namespace seaway::render
