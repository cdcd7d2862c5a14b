#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>
#include <span>

#include "sim_bridge/service/side_by_side.h"
#include "surface/disturbance/wake_listener.h"
#include "surface/field/wave_field.h"

namespace seaway::bridge {

/// Who listens at points of the sea plane, m, for ServedSea::attend: a circle about those that are
/// served at `t`. `vessel` as in WakeListener. Nothing where none is.
inline std::optional<WakeListener> listenerOf(std::span<const double> x, std::span<const double> y,
                                              double t, std::uint32_t vessel) noexcept {
  Extremes east = extremesOf(x), north = extremesOf(y);
  if (!WaveField::serves({east.low, north.low}, t) ||
      !WaveField::serves({east.high, north.high}, t)) {
    // Some are too far, or none is anywhere: without those.
    east = north = {};
    for (std::size_t i = 0; i < x.size(); ++i) {
      if (!WaveField::serves({x[i], y[i]}, t)) continue;
      east = {std::min(east.low, x[i]), std::max(east.high, x[i])};
      north = {std::min(north.low, y[i]), std::max(north.high, y[i])};
    }
    if (east.low > east.high) return std::nullopt;
  }
  return WakeListener{{0.5 * (east.low + east.high), 0.5 * (north.low + north.high)},
                      0.5 * std::hypot(east.high - east.low, north.high - north.low),
                      vessel};
}

}  // namespace seaway::bridge
