#include "sim_bridge/capi/wave_arrays.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "sim_bridge/capi/point_blocks.h"

namespace seaway::bridge::capi {
namespace {

using Floats = std::array<float, pointsPerBlock>;

void widen(const Floats& from, std::size_t first, std::size_t count, double* to) noexcept {
  if (to) std::copy_n(from.data(), count, to + first);
}

/// Points [first, first + count) of a call, and what every one of them that is served is told.
struct Told {
  const seaway_points& points;
  std::size_t first, count;
  double error;
  const seaway_samples& out;

  glm::dvec2 point(std::size_t i) const { return {points.first[i], points.second[i]}; }

  bool allServed(double t) const noexcept {
    bool all = WaveField::serves({0.0, 0.0}, t);
    for (std::size_t i = first; i < first + count; ++i) {
      all &= (std::abs(points.first[i]) <= WaveField::farthest) &
             (std::abs(points.second[i]) <= WaveField::farthest);
    }
    return all;
  }

  void tellAll(const WaveField& waves) const noexcept {
    const auto status = error > 0.0 ? SampleStatus::truncated : SampleStatus::ok;
    if (out.error) std::fill_n(out.error + first, count, error);
    if (out.status) std::fill_n(out.status + first, count, static_cast<std::uint32_t>(status));
    if (!out.bound) return;
    for (std::size_t i = first; i < first + count; ++i) {
      out.bound[i] = waves.bound(glm::length(point(i)));
    }
  }

  /// Of the others, as WaveField::sample has it.
  void tellUnserved(double t) const noexcept {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    for (std::size_t i = first; i < first + count; ++i) {
      if (WaveField::serves(point(i), t)) continue;
      const bool finite =
          std::isfinite(t) && std::isfinite(point(i).x) && std::isfinite(point(i).y);
      const auto status = finite ? SampleStatus::outOfRange : SampleStatus::notFinite;
      if (out.error) out.error[i] = nan;
      if (out.bound) out.bound[i] = nan;
      if (out.status) out.status[i] = static_cast<std::uint32_t>(status);
    }
  }
};

}  // namespace

bool isPlain(const SurfaceAtTime& water, const seaway_points& points,
             const SampleOptions& options) {
  return points.frame == SEAWAY_SEA_PLANE && !points.wanted && !options.orbitalVelocity &&
         options.shortestWavelength == 0.0 && !water.disturbances() && !water.outline() &&
         !water.terrain() &&
         !water.extras().events && !water.extras().detail;
}

void samplePlain(const SurfaceAtTime& water, const seaway_points& points, std::size_t first,
                 std::size_t end, const SampleOptions& options,
                 const seaway_samples& out) noexcept {
  const FieldAtTime& waves = water.waves();
  const WaveField& field = waves.field();
  const double error = options.tolerance > 0.0 ? field.leftOut(field.octavesFor(options.tolerance))
                                               : field.leftOut(field.octaves().size());
  Floats height, slopeX, slopeY, rate;
  for (; first < end; first += pointsPerBlock) {
    const std::size_t count = std::min(pointsPerBlock, end - first);
    FieldAtTime::Arrays arrays{std::span(height).first(count), {}, {}, {}};
    if (options.derivatives) {
      arrays.slopeX = std::span(slopeX).first(count);
      arrays.slopeY = std::span(slopeY).first(count);
      arrays.rate = std::span(rate).first(count);
    }
    waves.sample(std::span(points.first + first, count), std::span(points.second + first, count),
                 arrays, options);
    widen(height, first, count, out.height);
    if (options.derivatives) {
      widen(slopeX, first, count, out.slope_east);
      widen(slopeY, first, count, out.slope_north);
      widen(rate, first, count, out.vertical_velocity);
    }
    const Told told{points, first, count, error, out};
    told.tellAll(field);
    if (!told.allServed(water.time())) told.tellUnserved(water.time());
  }
}

}  // namespace seaway::bridge::capi
