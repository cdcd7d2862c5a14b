#pragma once

#include <cstdint>
#include <glm/vec2.hpp>

namespace seaway {

/// Someone who feels or sees the water around a place: a hull, a camera, the points of a query.
struct WakeListener {
  glm::dvec2 position{0.0};  ///< m, sea plane
  double radius = 0.0;       ///< m about it
  std::uint32_t vessel = 0;  ///< a hull does not call for its own wake; 0: nobody's own
};

/// Where a vessel floats, in the sea plane.
struct WakePose {
  double time = 0.0;         ///< s since the scene's epoch
  glm::dvec2 position{0.0};  ///< of the footprint's origin, m
  double heading = 0.0;      ///< direction of the bow, rad counter-clockwise from east
  double immersion = 1.0;    ///< part of the hull in the water, ≥ 0: 0 for a hull lifted out
};

}  // namespace seaway
