#pragma once

#include <cmath>
#include <cstdint>
#include <glm/vec2.hpp>
#include <limits>
#include <optional>
#include <span>

#include "surface/disturbance/wake_listener.h"
#include "surface/field/wave_field.h"

namespace seaway::bridge {

/// Who listens at points of the sea plane, m, for ServedSea::attend: a circle about those that are
/// served at `t`. `vessel` as in WakeListener. Nothing where none is.
inline std::optional<WakeListener> listenerOf(std::span<const double> x, std::span<const double> y,
                                              double t, std::uint32_t vessel) noexcept {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double west = infinity, east = -infinity, south = infinity, north = -infinity;
  const auto take = [&](std::size_t i) {
    // NaN is neither less nor more.
    west = x[i] < west ? x[i] : west;
    east = x[i] > east ? x[i] : east;
    south = y[i] < south ? y[i] : south;
    north = y[i] > north ? y[i] : north;
  };
  for (std::size_t i = 0; i < x.size(); ++i) take(i);
  if (!WaveField::serves({west, south}, t) || !WaveField::serves({east, north}, t)) {
    // Some are too far, or none is anywhere: without those.
    west = south = infinity, east = north = -infinity;
    for (std::size_t i = 0; i < x.size(); ++i) {
      if (WaveField::serves({x[i], y[i]}, t)) take(i);
    }
    if (west > east) return std::nullopt;
  }
  return WakeListener{{0.5 * (west + east), 0.5 * (south + north)},
                      0.5 * std::hypot(east - west, north - south),
                      vessel};
}

}  // namespace seaway::bridge
