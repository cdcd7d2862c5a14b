#include "sim_bridge/dynamics/hull_vessel.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "surface/angles.h"
#include "surface/constants.h"
#include "surface/state_archive.h"

namespace seaway::bridge {
namespace {

constexpr double subStepPhase = 0.1;  // rad of the fastest natural oscillation

/// Rotation by ω dt, exact for constant ω.
glm::dquat turned(const glm::dvec3& turning, double dt) {
  const double angle = glm::length(turning) * dt;
  if (angle < 1e-12) return glm::dquat(1.0, 0.5 * dt * turning);
  return glm::angleAxis(angle, turning * (dt / angle));
}

}  // namespace

HullVessel::HullVessel(std::shared_ptr<const HullModel> hull, const HullVesselSettings& settings)
    : hull_(std::move(hull)), settings_(settings) {
  place({0.0, 0.0}, 0.0, 0.0);
}

void HullVessel::place(glm::dvec2 position, double direction, double speed) {
  motion_ = {};
  motion_.worldFromBody = glm::angleAxis(direction, glm::dvec3(0.0, 0.0, 1.0));
  motion_.position = glm::dvec3(position, hull_->restHeight()) +
                     motion_.worldFromBody * hull_->settings().centreOfGravity;
  motion_.velocity = speed * (motion_.worldFromBody * glm::dvec3(1.0, 0.0, 0.0));
}

HullPose HullVessel::pose() const {
  const glm::dvec3 arm = motion_.worldFromBody * hull_->settings().centreOfGravity;
  HullPose pose;
  pose.position = motion_.position - arm;
  pose.worldFromBody = motion_.worldFromBody;
  pose.angularVelocity = motion_.worldFromBody * motion_.turning;
  pose.velocity = motion_.velocity - glm::cross(pose.angularVelocity, arm);
  return pose;
}

void HullVessel::setAutopilot(const AutopilotSettings& settings) {
  autopilot_.emplace(settings, glm::dvec2(pose().position));
}

glm::dvec3 HullVessel::inertia() const {
  return hull_->settings().mass * hull_->gyradii() * hull_->gyradii();
}

double HullVessel::energy() const {
  const double mass = hull_->settings().mass;
  return 0.5 * mass * glm::dot(motion_.velocity, motion_.velocity) +
         0.5 * glm::dot(inertia() * motion_.turning, motion_.turning) +
         mass * standardGravity * motion_.position.z;
}

int HullVessel::subSteps(double dt) const {
  const double fastest =
      std::max({hull_->heaveFrequency(), hull_->rollFrequency(), hull_->pitchFrequency()});
  return std::max(1, static_cast<int>(std::ceil(dt * fastest / subStepPhase)));
}

void HullVessel::advance(double t, const WaterSurface& water) {
  const double span = t - time_, from = time_;
  if (!(span > 0.0)) return;
  const int count = subSteps(span);
  for (int i = 1; i <= count; ++i) {
    subStep(span / count, water);
    time_ = i == count ? t : from + span * i / count;
  }
}

void HullVessel::steer(double dt, const glm::dvec3& speed) {
  if (autopilot_) {
    const glm::dvec3 bow = motion_.worldFromBody * glm::dvec3(1.0, 0.0, 0.0);
    const glm::dvec3 turning = motion_.worldFromBody * motion_.turning;
    helm_ = autopilot_->steer(
        {glm::dvec2(pose().position), std::atan2(bow.y, bow.x), turning.z, speed.x}, dt,
        settings_.propeller, settings_.rudder);
  }
  const double most = radiansFromDegrees(settings_.rudder.mostRate_deg) * dt;
  rudder_ += std::clamp(helm_.rudder - rudder_, -most, most);
}

double HullVessel::immersionOf(const Propeller& screw, const glm::dvec3& place,
                               const WaterSurface& water) const {
  if (!(screw.diameter > 0.0)) return 0.0;
  const SampleOptions options{.derivatives = false, .excludeVessel = settings_.loads.ownWake};
  const double surface = water.sample(glm::dvec2(place), time_, options).height;
  return std::isnan(surface) ? 1.0  // ashore: loads tell
                             : std::clamp(0.5 + (surface - place.z) / screw.diameter, 0.0, 1.0);
}

void HullVessel::subStep(double dt, const WaterSurface& water) {
  const HullSettings& hull = hull_->settings();
  loads_ = loads(*hull_, pose(), water, time_, scratch_, settings_.loads);
  status_ |= loads_.status;
  const glm::dmat3 worldFromBody = glm::mat3_cast(motion_.worldFromBody);
  const glm::dmat3 bodyFromWorld = glm::transpose(worldFromBody);
  const glm::dvec3 current(water.waves().settings().current, 0.0);
  const glm::dvec3 u = bodyFromWorld * (motion_.velocity - current);
  const glm::dvec3 w = motion_.turning;
  const Load outer = loads_.total();
  const glm::dvec3 weight(0.0, 0.0, -hull.mass * standardGravity);
  glm::dvec3 force = bodyFromWorld * (outer.force + weight);
  glm::dvec3 moment =
      bodyFromWorld * outer.moment - glm::cross(hull.centreOfGravity, bodyFromWorld * outer.force);
  steer(dt, u);
  if (settings_.propeller.diameter > 0.0 || settings_.rudder.area > 0.0) {
    const Propeller& screw = settings_.propeller;
    const glm::dvec3 place = pose().position + worldFromBody * screw.position;
    const double immersion = immersionOf(screw, place, water);
    const glm::dvec3 atOrigin = u - glm::cross(w, hull.centreOfGravity);
    const Load thrust = propellerLoad(screw, helm_.revolutions, atOrigin, immersion);
    const Load steering = rudderLoad(settings_.rudder, rudder_, atOrigin, w, screw, thrust.force.x);
    const glm::dvec3 sum = thrust.force + steering.force;
    force += sum;
    moment += thrust.moment + steering.moment - glm::cross(hull.centreOfGravity, sum);
  }
  const auto& a = loads_.addedMass;
  const glm::dvec3 added(a[0], a[1], a[2]), addedInertia(a[3], a[4], a[5]);
  const glm::dvec3 mass = hull.mass + added, turningMass = inertia() + addedInertia;
  // (m + A)(u̇ + ω × u) = F + A a_water + A (ω × u) − ω × (A u): the left bracket is the world's.
  force += added * (bodyFromWorld * loads_.waterAcceleration + glm::cross(w, u)) -
           glm::cross(w, added * u);
  moment -= glm::cross(u, added * u);
  motion_.velocity += dt * (worldFromBody * (force / mass));
  // Angular momentum in the world's axes, so that a free spin keeps it.
  const glm::dvec3 momentum = turningMass * w + dt * moment;
  const glm::dquat turn = turned(momentum / turningMass, dt);
  motion_.turning = (glm::inverse(turn) * momentum) / turningMass;
  motion_.worldFromBody = glm::normalize(motion_.worldFromBody * turn);
  motion_.position += dt * motion_.velocity;
}

template <class Archive>
void HullVessel::archive(Archive& archive) {
  archivePlain(archive, motion_);
  archivePlain(archive, helm_);
  archivePlain(archive, rudder_);
  archivePlain(archive, time_);
  if (autopilot_) autopilot_->archive(archive);
  archivePlain(archive, settings_.loads.ownWake);
  archivePlain(archive, loads_);
  archivePlain(archive, status_);
}

template void HullVessel::archive(StateWriter&);
template void HullVessel::archive(StateReader&);

}  // namespace seaway::bridge
