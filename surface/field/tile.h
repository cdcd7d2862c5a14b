#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <span>

#include "surface/field/kernels/field_blocks.h"
#include "surface/field/wave_field.h"
#include "surface/surface_sample.h"

namespace seaway {

/// Writes one point's sums (height, surface or orbital) into a sample that is blank.
inline void storeSums(Quantities what, const float* sums, glm::dvec2 current,
                      SurfaceSample& sample) noexcept {
  sample.height = sums[0];
  if (what == Quantities::height) return;
  sample.slope = {sums[1], sums[2]};
  sample.verticalVelocity = sums[3];
  if (what != Quantities::orbital || has(sample.status, SampleStatus::noKinematics)) return;
  // The water rises as the surface that carries it along does: ∂η/∂t + U·∇η.
  sample.orbitalVelocity = {sums[4], sums[5],
                            sample.verticalVelocity + glm::dot(current, sample.slope)};
}

/// Coordinates and sums of up to `pointsPerTile` points on the stack, aligned and padded for the
/// kernels.
class Tile {
 public:
  explicit Tile(Quantities what, float depth = 0.0f) : what_(what), depth_(depth) {}

  /// Takes points and clears the sums.
  void load(std::span<const glm::dvec2> points) noexcept {
    allServed_ = true;
    for (std::size_t i = 0; i < points.size(); ++i) put(i, points[i].x, points[i].y);
    pad(points.size());
  }
  void load(std::span<const double> x, std::span<const double> y) noexcept {
    allServed_ = true;
    for (std::size_t i = 0; i < x.size(); ++i) put(i, x[i], y[i]);
    pad(x.size());
  }

  /// Takes stretched heights of the points loaded, for pressure and motion.
  void loadStretched(std::span<const float> heights) noexcept {
    std::copy(heights.begin(), heights.end(), stretched_);
    std::fill(stretched_ + heights.size(), stretched_ + padded(heights.size()), 0.0f);
  }

  /// Whether every point loaded is finite and within WaveField::farthest.
  bool allServed() const { return allServed_; }

  const double* x() const { return x_; }
  const double* y() const { return y_; }

  FieldSums sums() {
    FieldSums sums{what_, {}, stretched_, depth_};
    for (std::size_t n = 0; n < mostSums; ++n) sums.sum[n] = sum_[n];
    return sums;
  }
  const float* sum(std::size_t which) const { return sum_[which]; }

  /// Copies the sums of point `i` into a sample.
  void store(std::size_t i, glm::dvec2 current, SurfaceSample& sample) const noexcept {
    float values[mostSums] = {};
    for (std::size_t n = 0; n < sumsOf(what_); ++n) values[n] = sum_[n][i];
    storeSums(what_, values, current, sample);
  }

 private:
  static std::size_t padded(std::size_t count) { return (count + 15) / 16 * 16; }

  void put(std::size_t i, double x, double y) noexcept {
    // Points that are not served are taken as 0: the caller marks their results.
    const bool served = (std::abs(x) <= WaveField::farthest) & (std::abs(y) <= WaveField::farthest);
    x_[i] = served ? x : 0.0;
    y_[i] = served ? y : 0.0;
    allServed_ &= served;
  }
  void pad(std::size_t count) noexcept {
    for (std::size_t i = count; i < padded(count); ++i) x_[i] = y_[i] = 0.0;
    for (std::size_t n = 0; n < sumsOf(what_); ++n) {
      std::fill(sum_[n], sum_[n] + padded(count), 0.0f);
    }
  }

  Quantities what_;
  float depth_;
  bool allServed_ = true;
  alignas(64) double x_[pointsPerTile];
  alignas(64) double y_[pointsPerTile];
  alignas(64) float stretched_[pointsPerTile];
  alignas(64) float sum_[mostSums][pointsPerTile];
};

}  // namespace seaway
