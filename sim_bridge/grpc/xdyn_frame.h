#pragma once

#include <cmath>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "surface/angles.h"

/// xdyn's frame: x north, y east, z down, from the scene's anchor on the still water.
namespace seaway::bridge::rpc {

inline glm::dvec2 planeFromXdyn(double x, double y) { return {y, x}; }
inline glm::dvec3 xdynFromPlane(glm::dvec3 v) { return {v.y, v.x, -v.z}; }
/// Where waves go to, rad from north towards east in (−π, π], of a direction counter-clockwise from
/// east.
inline double xdynDirectionFromPlane(double toward) {
  return std::remainder(0.5 * pi - toward, 2.0 * pi);
}

}  // namespace seaway::bridge::rpc
