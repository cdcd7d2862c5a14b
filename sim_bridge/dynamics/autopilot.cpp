#include "sim_bridge/dynamics/autopilot.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "surface/angles.h"
#include "surface/constants.h"
#include "surface/state_archive.h"

namespace seaway::bridge {
namespace {

double cross(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }

}  // namespace

Autopilot::Autopilot(const AutopilotSettings& settings, glm::dvec2 start)
    : settings_(settings), start_(start) {}

glm::dvec2 Autopilot::legStart() const {
  return next_ == 0 ? start_ : settings_.waypoints[next_ - 1];
}

glm::dvec2 Autopilot::legEnd() const { return settings_.waypoints[next_]; }

double Autopilot::crossTrack(glm::dvec2 position) const {
  if (settings_.waypoints.empty()) return 0.0;
  const glm::dvec2 leg = legEnd() - legStart();
  const double size = glm::length(leg);
  return size > 0.0 ? cross(leg, position - legStart()) / size : 0.0;
}

Helm Autopilot::steer(const View& view, double dt, const Propeller& propeller,
                      const Rudder& rudder) {
  Helm helm;
  const double error = settings_.speed - view.speed;
  // Revolutions that advance at the zero-thrust ratio are a start; the rest is integrated.
  const double ideal = propeller.diameter > 0.0
                           ? settings_.speed / (propeller.diameter * propeller.zeroThrustAdvance)
                           : 0.0;
  const double gain = propeller.diameter > 0.0 ? 1.0 / propeller.diameter : 0.0;
  const double settling = 10.0 * settings_.shipLength / std::max(std::abs(settings_.speed), 0.5);
  const double asked = ideal + gain * error + revolutions_;
  helm.revolutions = std::clamp(asked, -propeller.mostRevolutions, propeller.mostRevolutions);
  if (helm.revolutions == asked) revolutions_ += gain * error * dt / settling;
  if (settings_.waypoints.empty()) return helm;
  while (next_ + 1 < settings_.waypoints.size()) {
    const glm::dvec2 left = legEnd() - view.position, leg = legEnd() - legStart();
    if (glm::length(left) > 3.0 * settings_.shipLength && glm::dot(left, leg) > 0.0) break;
    ++next_;
  }
  const glm::dvec2 leg = legEnd() - legStart();
  const double wanted = std::atan2(leg.y, leg.x) -
                        std::atan(crossTrack(view.position) / (4.0 * settings_.shipLength));
  const double turn = std::remainder(wanted - view.direction, 2.0 * pi);
  const double damping = settings_.dampingTime > 0.0
                             ? settings_.dampingTime
                             : 0.6 * settings_.shipLength / std::max(std::abs(view.speed), 0.5);
  const double most = radiansFromDegrees(rudder.mostAngle_deg);
  helm.rudder = std::clamp(-settings_.headingGain * (turn - damping * view.turnRate), -most, most);
  return helm;
}

template <class Archive>
void Autopilot::archive(Archive& archive) {
  archivePlain(archive, next_);
  archivePlain(archive, revolutions_);
}

template void Autopilot::archive(StateWriter&);
template void Autopilot::archive(StateReader&);

}  // namespace seaway::bridge
