#include "sim_bridge/vessel/free_vessel.h"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "surface/angles.h"
#include "surface/state_archive.h"

namespace seaway::bridge {

FreeVessel::FreeVessel(HullVessel body, const Course& before)
    : body_(std::move(body)), track_(before) {
  submergedVolume_ = mass() / seaWaterDensity;
  notePlace();
}

VesselPose FreeVessel::pose() const {
  const HullPose pose = body_.pose();
  const glm::dvec3 waterline(0.0, 0.0, -body_.hull().restHeight());
  return vesselPose(pose.position + pose.worldFromBody * waterline, pose.worldFromBody);
}

double FreeVessel::speed() const {
  return glm::dot(glm::dvec2(body_.pose().velocity), unitVector(pose().direction));
}

void FreeVessel::notePlace() {
  const VesselPose now = pose();
  track_.record(time(), {now.position, now.direction, glm::dvec2(body_.pose().velocity)});
}

void FreeVessel::settle(const WaterSurface& water, std::uint32_t ownWake) {
  constexpr std::size_t probes = HullModel::probes;
  const VesselPose upright = pose();
  const glm::dquat level = upright.worldFromBody();
  const glm::dvec3 middle = body_.hull().bounds().middle();
  std::array<glm::dvec2, probes> places;
  std::array<SurfaceSample, probes> samples;
  for (std::size_t i = 0; i < probes; ++i) {
    places[i] = upright.position + glm::dvec2(level * body_.hull().probePlaces()[i]);
  }
  water.sample(places, time(), samples, {.excludeVessel = ownWake});
  double height = 0.0, rise = 0.0, along = 0.0, across = 0.0, xx = 0.0, yy = 0.0;
  for (std::size_t i = 0; i < probes; ++i) {
    const glm::dvec3 arm = body_.hull().probePlaces()[i] - middle;
    height += samples[i].height / probes;
    rise += samples[i].verticalVelocity / probes;
    along += arm.x * samples[i].height;
    across += arm.y * samples[i].height;
    xx += arm.x * arm.x;
    yy += arm.y * arm.y;
  }
  if (!std::isfinite(height + rise)) return;  // ashore: the first step tells
  VesselPose settled = upright;
  settled.pitch = std::atan(along / xx);
  settled.roll = std::atan(across / yy);
  RigidMotion motion = body_.motion();
  const glm::dquat turn = settled.worldFromBody() * glm::conjugate(motion.worldFromBody);
  const glm::dvec3 waterline(upright.position, upright.height);
  motion.position = waterline + turn * (motion.position - waterline) +
                    glm::dvec3(0.0, 0.0, height - middle.x * along / xx - middle.y * across / yy);
  motion.worldFromBody = glm::normalize(turn * motion.worldFromBody);
  motion.velocity = turn * motion.velocity + glm::dvec3(0.0, 0.0, rise);
  body_.setMotion(motion);
  readWater(water, ownWake);
}

void FreeVessel::advance(double t, const WaterSurface& water, std::uint32_t ownWake) {
  body_.setOwnWake(ownWake);
  body_.clearStatus();
  body_.advance(t, water);
  status_ = body_.status();
  submergedVolume_ = body_.lastLoads().submergedVolume;
  notePlace();
}

void FreeVessel::readWater(const WaterSurface& water, std::uint32_t ownWake) {
  waterHeight_ =
      water.sample(pose().position, time(), {.derivatives = false, .excludeVessel = ownWake})
          .height;
}

std::size_t FreeVessel::memoryBytes() const {
  return sizeof(FreeVessel) + body_.memoryBytes() + track_.memoryBytes();
}

template <class Archive>
void FreeVessel::archive(Archive& archive) {
  body_.archive(archive);
  track_.archive(archive);
  archivePlain(archive, waterHeight_);
  archivePlain(archive, submergedVolume_);
  archivePlain(archive, status_);
}

template void FreeVessel::archive(StateWriter&);
template void FreeVessel::archive(StateReader&);

}  // namespace seaway::bridge
