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

/// What is left to say of points [first, first + count): as WaveField::sample has it.
void tellOf(const WaveField& waves, double t, const seaway_points& points, std::size_t first,
            std::size_t count, double error, const seaway_samples& out) noexcept {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const auto kept =
      static_cast<std::uint32_t>(error > 0.0 ? SampleStatus::truncated : SampleStatus::ok);
  for (std::size_t i = first; i < first + count; ++i) {
    const glm::dvec2 point(points.first[i], points.second[i]);
    const bool served = WaveField::serves(point, t);
    if (out.error) out.error[i] = served ? error : nan;
    if (out.bound) out.bound[i] = served ? waves.bound(glm::length(point)) : nan;
    if (!out.status) continue;
    const bool finite = std::isfinite(t) && std::isfinite(point.x) && std::isfinite(point.y);
    const SampleStatus unserved = finite ? SampleStatus::outOfRange : SampleStatus::notFinite;
    out.status[i] = served ? kept : static_cast<std::uint32_t>(unserved);
  }
}

}  // namespace

bool isPlain(const SurfaceAtTime& water, const seaway_points& points,
             const SampleOptions& options) {
  return points.frame == SEAWAY_SEA_PLANE && !points.wanted && !options.orbitalVelocity &&
         options.shortestWavelength == 0.0 && !water.disturbances() && !water.outline() &&
         !water.extras().events && !water.extras().detail;
}

void samplePlain(const SurfaceAtTime& water, const seaway_points& points, std::size_t first,
                 std::size_t end, const SampleOptions& options, const seaway_samples& out) noexcept {
  const FieldAtTime& waves = water.waves();
  const WaveField& field = waves.field();
  const double error = options.tolerance > 0.0
                           ? field.leftOut(field.octavesFor(options.tolerance))
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
    if (out.error || out.bound || out.status) {
      tellOf(field, water.time(), points, first, count, error, out);
    }
  }
}

}  // namespace seaway::bridge::capi
