#pragma once

#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "surface/field/lattice_hash.h"

namespace seaway {

/// A coordinate that is linear in place and time: gradient · x + rate · t + offset, in lattice
/// cells or in turns of phase.
struct LinearCoordinate {
  glm::dvec2 gradient{0.0};  ///< cells/m or turns/m
  double rate = 0.0;         ///< cells/s or turns/s at a fixed point
  double offset = 0.0;       ///< cells or turns

  double at(glm::dvec2 point) const { return glm::dot(gradient, point) + offset; }
};

/// rate · t + offset split into whole units and the rest, without losing what the product rounds
/// away: precise for t up to 2⁵³ units over the rate.
struct SplitOffset {
  std::int64_t whole;
  double rest;  ///< [0, 1)
};

inline SplitOffset offsetAt(const LinearCoordinate& coordinate, double t) {
  const double product = coordinate.rate * t;
  const double lost = std::fma(coordinate.rate, t, -product);
  const double whole = std::floor(product);
  const double rest = (product - whole) + lost + coordinate.offset;
  const double more = std::floor(rest);
  // Beyond 2⁶² units no fraction is left to be right about.
  const double units = std::fmin(std::fmax(whole, -4.6e18), 4.6e18);
  return {static_cast<std::int64_t>(units) + static_cast<std::int64_t>(more), rest - more};
}

/// The lattice coordinate at time t: whole cells travel into the seed of its axis, so that neither
/// distance nor time costs precision.
inline LinearCoordinate latticeAt(const LinearCoordinate& coordinate, double t, std::uint32_t& seed,
                                  std::uint32_t stride) {
  const SplitOffset split = offsetAt(coordinate, t);
  seed += static_cast<std::uint32_t>(split.whole) * stride;
  return {coordinate.gradient, coordinate.rate, split.rest};
}

/// The phase in turns at time t, its offset in [0, 1).
inline LinearCoordinate turnsAt(const LinearCoordinate& coordinate, double t) {
  return {coordinate.gradient, coordinate.rate, offsetAt(coordinate, t).rest};
}

}  // namespace seaway
