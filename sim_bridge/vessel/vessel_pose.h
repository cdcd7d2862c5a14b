#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace seaway::bridge {

/// Where a vessel is and how it lies: its body frame's point on the waterline at rest (BoxHull).
struct VesselPose {
  glm::dvec2 position{0.0};  ///< sea plane, m
  double direction = 0.0;    ///< of the bow, rad counter-clockwise from east
  double height = 0.0;       ///< of the body origin above the still-water level, m
  double pitch = 0.0;        ///< rad, positive bow up
  double roll = 0.0;         ///< rad, positive starboard down

  glm::dquat worldFromBody() const;
};

/// The pose of a body at a place, with a unit quaternion: roll in (−π, π], pitch in [−π/2, π/2].
/// worldFromBody() of it is the quaternion again, within 1e-7 rad where the bow stands upright.
VesselPose vesselPose(const glm::dvec3& position, const glm::dquat& worldFromBody);

}  // namespace seaway::bridge
