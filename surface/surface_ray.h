#pragma once

#include <glm/vec3.hpp>
#include <optional>

#include "surface/water_surface.h"

namespace seaway {

struct RayOptions {
  double tolerance = 1e-4;     ///< m along the ray, > 0
  double nearDistance = 0.1;   ///< m: where the ray starts
  double farDistance = 100e3;  ///< m: where it gives up
  double leastStep = 1e-3;     ///< part of the distance travelled
  bool curved = true;  ///< bend the sea below the origin (`seaDrop`); false: a flat sea plane
};

/// Distance in metres along a ray to the water, from above or from below: its first hit; empty
/// where it meets none, or where the ray is not finite; outside the water's outline flat ground at
/// still-water level ends the ray, and so does terrain that stands above the water. For lidars,
/// radars and cameras; the truth that images and depths are compared with.
///
/// `origin` is in the sea plane's frame (its foot point is where the sea's curvature is measured
/// from), `direction` a unit vector. Steps follow the height above water over
/// the steepest slope to be expected (six standard deviations of slope), never less than
/// `leastStep` times the distance; a crest thinner than that may be missed. The crossing is then
/// bisected to `tolerance`. Thread-safe.
std::optional<double> distanceToWater(const SurfaceAtTime& water, glm::dvec3 origin,
                                      glm::dvec3 direction, const RayOptions& options = {});

}  // namespace seaway
