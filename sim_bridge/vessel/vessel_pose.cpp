#include "sim_bridge/vessel/vessel_pose.h"

#include <cmath>

#include "render/camera.h"

namespace seaway::bridge {

glm::dquat VesselPose::worldFromBody() const { return render::attitude(direction, pitch, roll); }

VesselPose vesselPose(const glm::dvec3& position, const glm::dquat& worldFromBody) {
  const glm::dvec3 forward = worldFromBody * glm::dvec3(1.0, 0.0, 0.0);
  const double direction = std::atan2(forward.y, forward.x);
  const double pitch = std::atan2(forward.z, std::hypot(forward.x, forward.y));
  // Roll is what remains once heading and pitch are taken away: defined with the bow upright too.
  const glm::dquat rolled = glm::conjugate(render::attitude(direction, pitch, 0.0)) * worldFromBody;
  const glm::dvec3 port = rolled * glm::dvec3(0.0, 1.0, 0.0);
  return {glm::dvec2(position), direction, position.z, pitch, std::atan2(port.z, port.y)};
}

}  // namespace seaway::bridge
