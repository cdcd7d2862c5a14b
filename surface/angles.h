#pragma once

#include <cmath>
#include <glm/vec2.hpp>

#include "surface/constants.h"

/// Conversions between compass degrees (files, command line) and the radians used inside.
///
/// Inside, a direction is where something goes *toward*, in radians counter-clockwise from east.
/// Compass degrees run clockwise from north; a name says whether they are `toward` or `from`.
namespace seaway {

constexpr double radiansFromDegrees(double degrees) { return degrees * (pi / 180.0); }
constexpr double degreesFromRadians(double radians) { return radians * (180.0 / pi); }

/// `degrees` brought into [0, 360).
inline double compassWrapped(double degrees) {
  const double wrapped = std::fmod(degrees, 360.0);
  return wrapped < 0.0 ? wrapped + 360.0 : wrapped;
}

constexpr double towardFromCompassToward(double toward_deg) {
  return radiansFromDegrees(90.0 - toward_deg);
}
constexpr double towardFromCompassFrom(double from_deg) {
  return radiansFromDegrees(270.0 - from_deg);
}
inline double compassTowardFromToward(double toward) {
  return compassWrapped(90.0 - degreesFromRadians(toward));
}
inline double compassFromFromToward(double toward) {
  return compassWrapped(270.0 - degreesFromRadians(toward));
}

/// Unit vector (east, north) of a direction in radians counter-clockwise from east.
inline glm::dvec2 unitVector(double direction) {
  return {std::cos(direction), std::sin(direction)};
}

}  // namespace seaway
