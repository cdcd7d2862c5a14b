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
#include "render/grid_skip.h"
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

/// Takes `weight` of `other` for as much of `values`.
void mixIn(const std::array<float, chunk>& other, float weight, int count,
           std::array<float, chunk>& values) {
  for (int i = 0; i < count; ++i) values[i] += weight * (other[i] - values[i]);
}

/// The waves that a row carries.
void sampleWaves(const SurfaceAtTime& water, std::span<const double> x, std::span<const double> y,
                 const BandLimit::Plan& plan, Waves& waves) {
  const int count = static_cast<int>(x.size());
  water.waves().sample(x, y, waves.arrays(count), {.shortestWavelength = plan.keptWavelength});
  if (plan.weight <= 0.0) return;
  const auto weight = static_cast<float>(plan.weight);
  Waves fading;
  water.waves().sample(x, y, fading.arrays(count), {.shortestWavelength = plan.fadingWavelength});
  mixIn(fading.height, weight, count, waves.height);
  mixIn(fading.slopeX, weight, count, waves.slopeX);
  mixIn(fading.slopeY, weight, count, waves.slopeY);
}

/// Takes the heights of the largest octaves alone: those that leave `tolerance` m (1 σ).
void keepLargest(const SurfaceAtTime& water, std::span<const double> x, std::span<const double> y,
                 const BandLimit::Plan& plan, double tolerance, Waves& waves) {
  const int count = static_cast<int>(x.size());
  const auto heights = [&](std::array<float, chunk>& to, double shortest) {
    water.waves().sample(
        x, y, {.height = std::span(to.data(), count), .slopeX = {}, .slopeY = {}, .rate = {}},
        {.tolerance = tolerance, .shortestWavelength = shortest, .derivatives = false});
  };
  heights(waves.height, plan.keptWavelength);
  if (plan.weight <= 0.0) return;
  std::array<float, chunk> fading;
  heights(fading, plan.fadingWavelength);
  mixIn(fading, static_cast<float>(plan.weight), count, waves.height);
}

}  // namespace

void SeaGrid::fill(const SurfaceAtTime& water, const Camera& camera, const GridLayout& layout,
                   double bound, const Surf* surf) {
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
  shown_.clear();
  if (layout.rings) shown_ = batchesInView(layout, camera, bound, batch);
  surf_ = surf;
  if (mayHaveCover(water.extras(), surf)) {
    cover_.resize(vertexCount());
  } else {
    cover_.clear();
  }
  if (water.outline()) hideDry(*water.outline(), camera, layout);
  tbb::parallel_for(0, size_.y,
                    [&](int row) { rowLargest_[row] = fillRow(water, camera, layout, row); });
  largestHeight_ = *std::max_element(rowLargest_.begin(), rowLargest_.end());
}

/// Hides batches that lie wholly outside the outline.
void SeaGrid::hideDry(const WaterOutline& outline, const Camera& camera, const GridLayout& layout) {
  shown_.resize(static_cast<std::size_t>(size_.y - 1) * batches(), 1);
  const glm::dvec2 foot(camera.position);
  tbb::parallel_for(0, size_.y - 1, [&](int row) {
    for (int b = 0; b < batches(); ++b) {
      const int first = b * batch, last = std::min(first + batch, size_.x - 1);
      glm::dvec2 least(std::numeric_limits<double>::infinity()), most = -least;
      for (const int line : {row, row + 1}) {
        // Of a straight row the ends say it all.
        for (int column = first; column <= last; column += layout.rings ? 1 : last - first) {
          const glm::dvec2 corner = foot + layout.place(line, column);
          least = glm::min(least, corner);
          most = glm::max(most, corner);
        }
      }
      std::uint8_t& shown = shown_[static_cast<std::size_t>(row) * batches() + b];
      shown = shown && outline.mayMeet(least, most);
    }
  });
}

/// Whether a batch that has a vertex of this column's batch may show.
bool SeaGrid::isAsked(int row, int column) const {
  if (shown_.empty()) return true;
  const int here = std::min(column / batch, batches() - 1);
  for (const int line : {row - 1, row}) {
    for (const int b : {here - 1, here}) {
      if (line >= 0 && line + 1 < size_.y && b >= 0 && mayShow(line, b)) return true;
    }
  }
  return false;
}

double SeaGrid::fillRow(const SurfaceAtTime& water, const Camera& camera, const GridLayout& layout,
                        int row) {
  missingSlope_[row] = static_cast<float>(layout.rows[row].plan.missingSlope);
  double largest = 0.0;
  for (int first = 0; first < size_.x;) {
    const bool asked = isAsked(row, first);
    int end = first + (shown_.empty() ? chunk : batch);
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
                          const GridLayout& layout, int row, int first, int count) {
  const BandLimit::Plan& plan = layout.rows[row].plan;
  const WaterOutline* outline = water.outline();
  const bool asked = isAsked(row, first);
  std::array<double, chunk> x, y;
  Waves waves;
  for (int i = 0; i < count; ++i) {
    const glm::dvec2 point = glm::dvec2(camera.position) + layout.place(row, first + i);
    x[i] = point.x;
    y[i] = point.y;
  }
  const std::span<const double> xs(x.data(), count), ys(y.data(), count);
  if (asked) sampleWaves(water, xs, ys, plan, waves);
  const double tolerance = layout.displacementToleranceAt(row);
  if (asked && tolerance > 0.0) {
    keepLargest(water, xs, ys, plan, tolerance, waves);
  }
  GridCover cover;
  if (asked) {
    cover.sample(water, xs, ys);
    if (surf_) cover.addSurf(*surf_, water, xs, ys, plan.keptWavelength);
    addExtras(water, xs, ys, plan.keptWavelength, cover, waves.arrays(count));
  }
  double largest = 0.0;
  const std::size_t at = static_cast<std::size_t>(row) * size_.x + first;
  for (int i = 0; i < count && !cover_.empty(); ++i) {
    cover_[at + i] = cover.any ? cover.packed(static_cast<std::size_t>(i)) : 0u;
  }
  if (asked && !wakes_.empty()) addWakes(xs, ys, plan.spacing, at, waves.arrays(count));
  for (int i = 0; i < count; ++i) {
    float height = 0.0f, slopeX = 0.0f, slopeY = 0.0f;
    // Where the field has no answer the sea is drawn still: a hole would look like sky. Outside its
    // outline it lies as the ground does.
    const bool wet = asked && (!outline || outline->contains({x[i], y[i]}));
    if (wet && std::isfinite(waves.height[i])) {
      height = waves.height[i];
      slopeX = waves.slopeX[i];
      slopeY = waves.slopeY[i];
    }
    const glm::dvec2 base = layout.place(row, first + i);
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
  const glm::dvec2 half = camera.halfPicture(), middle = camera.pictureMiddle();
  const glm::vec3 forward(camera.forward());
  const glm::vec3 right((-camera.left() - middle.x * camera.forward()) / half.x);
  const glm::vec3 up((camera.up() - middle.y * camera.forward()) / half.y);
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
  return (x_.capacity() + y_.capacity() + z_.capacity() + height_.capacity() + slopeX_.capacity() +
          slopeY_.capacity() + missingSlope_.capacity() + missingWakes_.capacity()) *
             sizeof(float) +
         wakes_.memoryBytes() + cover_.capacity() * sizeof(std::uint32_t) +
         rowLargest_.capacity() * sizeof(double) + shown_.capacity();
}

}  // namespace seaway::render
