#include "sim_bridge/dynamics/propulsion.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "surface/constants.h"

namespace seaway::bridge {

// ρ n |n| D⁴ K₀ (1 − J/J₀), J = u/(nD), without dividing by n.
Load propellerLoad(const Propeller& p, double revolutions, const glm::dvec3& speed,
                   double immersion) {
  if (!(p.diameter > 0.0)) return {};
  const double inflow = (1.0 - p.wakeFraction) * speed.x;
  const double d2 = p.diameter * p.diameter;
  const double thrust = seaWaterDensity * d2 * d2 * p.bollardThrust * std::abs(revolutions) *
                        (revolutions - inflow / (p.zeroThrustAdvance * p.diameter));
  const glm::dvec3 force((1.0 - p.thrustDeduction) * immersion * thrust, 0.0, 0.0);
  return {force, glm::cross(p.position, force)};
}

// The slipstream adds what momentum theory says: u² + 2T/(ρ A₀) far behind the disc A₀.
Load rudderLoad(const Rudder& r, double angle, const glm::dvec3& speed, const glm::dvec3& turning,
                const Propeller& propeller, double thrust) {
  if (!(r.area > 0.0)) return {};
  const glm::dvec3 own = speed + glm::cross(turning, r.position);
  double along = own.x;
  if (propeller.diameter > 0.0) {
    along *= 1.0 - propeller.wakeFraction;
    const double disc = 0.25 * pi * propeller.diameter * propeller.diameter;
    const double squared = along * std::abs(along) + 2.0 * thrust / (seaWaterDensity * disc);
    along = std::copysign(std::sqrt(std::abs(squared)), squared);
  }
  const double slope = 6.13 * r.aspectRatio / (r.aspectRatio + 2.25);
  // A stern that moves to port meets water that comes from there.
  const double incidence = angle - std::atan2(own.y, std::max(std::abs(along), 1e-6));
  const double normal = 0.5 * seaWaterDensity * r.area * slope *
                        (along * std::abs(along) + own.y * own.y) * std::sin(incidence);
  const glm::dvec3 force(-std::abs(normal * std::sin(angle)) * (along >= 0.0 ? 1.0 : -1.0),
                         normal * std::cos(angle), 0.0);
  return {force, glm::cross(r.position, force)};
}

}  // namespace seaway::bridge
