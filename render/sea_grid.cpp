#include "render/sea_grid.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "render/grid_cover.h"
#include "surface/curvature.h"

namespace seaway::render {
namespace {

constexpr int chunk = gridChunk;  // columns sampled at a time

/// Heights and slopes of a chunk of a row.
struct Waves {
  std::array<float, chunk> height, slopeX, slopeY;

  FieldAtTime::Arrays arrays(int count) {
    const auto part = [&](std::array<float, chunk>& all) { return std::span(all.data(), count); };
    return {part(height), part(slopeX), part(slopeY), {}};
  }
};

/// Takes `weight` of another set of waves for as much of these.
void mixIn(const Waves& other, float weight, int count, Waves& waves) {
  for (int i = 0; i < count; ++i) {
    waves.height[i] += weight * (other.height[i] - waves.height[i]);
    waves.slopeX[i] += weight * (other.slopeX[i] - waves.slopeX[i]);
    waves.slopeY[i] += weight * (other.slopeY[i] - waves.slopeY[i]);
  }
}

}  // namespace

void SeaGrid::fill(const SurfaceAtTime& water, const Camera& camera, const GridLayout& layout) {
  size_ = layout.size;
  for (auto* values : {&x_, &y_, &z_, &height_, &slopeX_, &slopeY_}) values->resize(vertexCount());
  missingSlope_.resize(size_.y);
  rowLargest_.resize(size_.y);
  wakes_.fill(water.disturbances(), water.time(), glm::dvec2(camera.position), layout);
  if (wakes_.empty()) {
    missingWakes_ = {};
  } else {
    missingWakes_.assign(vertexCount(), 0.0f);
  }
  wet_.clear();
  const SurfaceDetail* detail = water.extras().detail.get();
  if (detail && !detail->cover.empty()) {
    cover_.resize(vertexCount());
  } else {
    cover_.clear();
  }
  if (water.outline()) findWet(*water.outline(), camera, layout);
  tbb::parallel_for(0, size_.y, [&](int row) {
    rowLargest_[row] = fillRow(water, camera, layout.rows[row], row);
  });
  largestHeight_ = *std::max_element(rowLargest_.begin(), rowLargest_.end());
}

void SeaGrid::findWet(const WaterOutline& outline, const Camera& camera,
                      const GridLayout& layout) {
  wet_.resize(static_cast<std::size_t>(size_.y - 1) * batches());
  const glm::dvec2 foot(camera.position);
  tbb::parallel_for(0, size_.y - 1, [&](int row) {
    for (int b = 0; b < batches(); ++b) {
      const int first = b * batch, last = std::min(first + batch, size_.x - 1);
      glm::dvec2 least(std::numeric_limits<double>::infinity()), most = -least;
      for (const int line : {row, row + 1}) {
        for (const int column : {first, last}) {
          const GridLayout::Row& at = layout.rows[line];
          const glm::dvec2 corner = foot + at.start + at.step * static_cast<double>(column);
          least = glm::min(least, corner);
          most = glm::max(most, corner);
        }
      }
      wet_[static_cast<std::size_t>(row) * batches() + b] = outline.mayMeet(least, most);
    }
  });
}

/// Whether a batch that has a vertex of this column's batch may be wet.
bool SeaGrid::isAsked(int row, int column) const {
  if (wet_.empty()) return true;
  const int here = std::min(column / batch, batches() - 1);
  for (const int line : {row - 1, row}) {
    for (const int b : {here - 1, here}) {
      if (line >= 0 && line + 1 < size_.y && b >= 0 && mayBeWet(line, b)) return true;
    }
  }
  return false;
}

double SeaGrid::fillRow(const SurfaceAtTime& water, const Camera& camera,
                        const GridLayout::Row& layout, int row) {
  missingSlope_[row] = static_cast<float>(layout.plan.missingSlope);
  double largest = 0.0;
  for (int first = 0; first < size_.x;) {
    const bool asked = isAsked(row, first);
    int end = first + (wet_.empty() ? chunk : batch);
    while (end < size_.x && end - first < chunk && isAsked(row, end) == asked) end += batch;
    end = std::min(end, size_.x);
    largest = std::max(largest, fillPiece(water, camera, layout, row, first, end - first));
    first = end;
  }
  return largest;
}

/// Adds the wakes to waves at vertices from `at` on.
void SeaGrid::addWakes(std::span<const double> x, std::span<const double> y, double spacing,
                       std::size_t at, const FieldAtTime::Arrays& waves) {
  const std::span<float> missing = std::span(missingWakes_).subspan(at, x.size());
  wakes_.addTo(x, y, spacing, {waves.height, waves.slopeX, waves.slopeY, missing});
}

double SeaGrid::fillPiece(const SurfaceAtTime& water, const Camera& camera,
                          const GridLayout::Row& layout, int row, int first, int count) {
  const auto& [start, step, plan] = layout;
  const WaterOutline* outline = wet_.empty() ? nullptr : water.outline();
  const bool asked = isAsked(row, first), fades = plan.weight > 0.0 && asked;
  const auto weight = static_cast<float>(plan.weight);
  std::array<double, chunk> x, y;
  Waves waves, fading;
  for (int i = 0; i < count; ++i) {
    x[i] = camera.position.x + start.x + step.x * (first + i);
    y[i] = camera.position.y + start.y + step.y * (first + i);
  }
  const std::span<const double> xs(x.data(), count), ys(y.data(), count);
  if (asked) {
    water.waves().sample(xs, ys, waves.arrays(count), {.shortestWavelength = plan.keptWavelength});
  }
  if (fades) {
    water.waves().sample(xs, ys, fading.arrays(count),
                         {.shortestWavelength = plan.fadingWavelength});
  }
  if (fades) mixIn(fading, weight, count, waves);
  GridCover cover;
  if (asked) {
    cover.sample(water, xs, ys);
    addExtras(water, xs, ys, plan.keptWavelength, cover, waves.arrays(count));
  }
  double largest = 0.0;
  const std::size_t at = static_cast<std::size_t>(row) * size_.x + first;
  for (int i = 0; i < count && !cover_.empty(); ++i) {
    cover_[at + i] = cover.any ? cover.packed(static_cast<std::size_t>(i)) : 0u;
  }
  if (asked && !wakes_.empty()) addWakes(xs, ys, plan.spacing, at, waves.arrays(count));
  for (int i = 0; i < count; ++i) {
    float height = waves.height[i], slopeX = waves.slopeX[i], slopeY = waves.slopeY[i];
    // Where the field has no answer the sea is drawn still: a hole would look like sky. Outside its
    // outline it lies as the ground does.
    const bool dry = outline && (!asked || !outline->contains({x[i], y[i]}));
    if (dry || !std::isfinite(height)) height = slopeX = slopeY = 0.0f;
    const glm::dvec2 base = start + step * static_cast<double>(first + i);
    largest = std::max(largest, static_cast<double>(std::abs(height)));
    x_[at + i] = static_cast<float>(base.x);
    y_[at + i] = static_cast<float>(base.y);
    z_[at + i] = static_cast<float>(height - seaDrop(glm::length(base)) - camera.position.z);
    height_[at + i] = height;
    slopeX_[at + i] = slopeX;
    slopeY_[at + i] = slopeY;
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
          slopeX_.capacity() + slopeY_.capacity() + missingSlope_.capacity() + missingWakes_.capacity()) *
             sizeof(float) +
         wakes_.memoryBytes() + cover_.capacity() * sizeof(std::uint32_t) +
         rowLargest_.capacity() * sizeof(double) + wet_.capacity();
}

}  // namespace seaway::render
