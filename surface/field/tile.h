#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <span>

#include "surface/field/kernels/field_blocks.h"
#include "surface/surface_sample.h"

namespace seaway {

/// Coordinates and sums of up to `pointsPerTile` points on the stack, aligned and padded for the
/// kernels.
class Tile {
 public:
  /// Farthest point along each axis that is served, m.
  static constexpr double farthest = 1e12;

  explicit Tile(bool orbital) : orbital_(orbital) {}

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

  /// Whether every point loaded is finite and within `farthest`.
  bool allServed() const { return allServed_; }

  const double* x() const { return x_; }
  const double* y() const { return y_; }

  FieldSums sums() {
    return {height_, slopeX_, slopeY_, rate_, orbital_ ? orbitalX_ : nullptr,
            orbital_ ? orbitalY_ : nullptr};
  }

  /// Copies the sums of point `i` into a sample.
  void store(std::size_t i, glm::dvec2 current, SurfaceSample& sample) const noexcept {
    sample.height = height_[i];
    sample.slope = {slopeX_[i], slopeY_[i]};
    sample.verticalVelocity = rate_[i];
    if (!orbital_ || has(sample.status, SampleStatus::noKinematics)) return;
    // The water rises as the surface that carries it along does: ∂η/∂t + U·∇η.
    sample.orbitalVelocity = {orbitalX_[i], orbitalY_[i],
                              sample.verticalVelocity + glm::dot(current, sample.slope)};
  }

 private:
  void put(std::size_t i, double x, double y) noexcept {
    // Points that are not served are taken as 0: the caller marks their results.
    const bool served = (std::abs(x) <= farthest) & (std::abs(y) <= farthest);
    x_[i] = served ? x : 0.0;
    y_[i] = served ? y : 0.0;
    allServed_ &= served;
  }
  void pad(std::size_t count) noexcept {
    const std::size_t padded = (count + 15) / 16 * 16;
    for (std::size_t i = count; i < padded; ++i) x_[i] = y_[i] = 0.0;
    for (float* sum : {height_, slopeX_, slopeY_, rate_}) std::fill(sum, sum + padded, 0.0f);
    if (!orbital_) return;
    for (float* sum : {orbitalX_, orbitalY_}) std::fill(sum, sum + padded, 0.0f);
  }

  bool orbital_;
  bool allServed_ = true;
  alignas(64) double x_[pointsPerTile];
  alignas(64) double y_[pointsPerTile];
  alignas(64) float height_[pointsPerTile];
  alignas(64) float slopeX_[pointsPerTile];
  alignas(64) float slopeY_[pointsPerTile];
  alignas(64) float rate_[pointsPerTile];
  alignas(64) float orbitalX_[pointsPerTile];
  alignas(64) float orbitalY_[pointsPerTile];
};

}  // namespace seaway
