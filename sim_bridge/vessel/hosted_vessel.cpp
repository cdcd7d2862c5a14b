#include "sim_bridge/vessel/hosted_vessel.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "sim_bridge/vessel/pose_between.h"
#include "surface/angles.h"
#include "surface/constants.h"

namespace seaway::bridge {
namespace {

constexpr double fastest = 100.0;   // m/s, as PoseLog has it: what is faster is no sailing
constexpr double reckonedOn = 1.0;  // s after the last pose

// A host far ahead of the steps is remembered this far, so that one that never steps costs no more.
constexpr std::size_t mostPoses = 4096;

}  // namespace

HostedVessel::HostedVessel(const BoxHull& hull, double t, const VesselPose& now, VesselTrack before)
    : hull_(hull), columns_(hullColumns(hull)), time_(t), track_(std::move(before)) {
  poses_.push_back({t, now});
  submergedVolume_ = hull_.mass() / seaWaterDensity;
  points_.resize(columns_.size() + 1);
  samples_.resize(points_.size());
}

bool HostedVessel::place(double t, const VesselPose& pose) {
  // What the vessel was at `time_` gives way to the host's first pose at that time.
  if (!placed_ && t == poses_.back().time) {
    poses_.back().pose = pose;
    placed_ = true;
    return true;
  }
  if (!(t > poses_.back().time) || t < time_) return false;
  poses_.push_back({t, pose});
  if (poses_.size() > mostPoses) poses_.erase(poses_.begin() + 2);
  placed_ = true;
  return true;
}

VesselPose HostedVessel::at(double t) const {
  const auto later = std::find_if(poses_.begin(), poses_.end(),
                                  [=](const TimedPose& pose) { return pose.time > t; });
  if (later == poses_.begin()) return poses_.front().pose;
  const bool isLast = later == poses_.end();
  if (isLast && poses_.size() < 2) return poses_.back().pose;
  const TimedPose& b = isLast ? poses_.back() : *later;
  const TimedPose& a = isLast ? poses_[poses_.size() - 2] : *(later - 1);
  const double span = b.time - a.time;
  const bool jumps = glm::distance(a.pose.position, b.pose.position) > fastest * span;
  if (jumps) return isLast ? b.pose : a.pose;
  const double reached = isLast ? std::min(t, b.time + reckonedOn) : t;
  VesselPose pose = poseBetween(a.pose, b.pose, (reached - a.time) / span);
  if (isLast) {  // attitudes are not reckoned on: they swing
    pose.height = b.pose.height;
    pose.pitch = b.pose.pitch;
    pose.roll = b.pose.roll;
  }
  return pose;
}

CoursePoint HostedVessel::groundAt(double t) const {
  constexpr double interval = 0.05;  // s, over which the velocity is taken
  const VesselPose now = at(t), before = at(t - interval);
  const glm::dvec2 moved = now.position - before.position;
  const bool jumped = glm::length(moved) > fastest * interval;
  return {now.position, now.direction, jumped ? glm::dvec2(0.0) : moved / interval};
}

void HostedVessel::moveTo(double t) {
  time_ = t;
  track_.record(t, groundAt(t));
  // Two poses before now say how fast it goes.
  while (poses_.size() > 2 && poses_[2].time <= t - reckonedOn) poses_.pop_front();
}

void HostedVessel::readWater(const WaterSurface& water, std::uint32_t ownWake) {
  const VesselPose now = pose();
  const glm::dquat worldFromBody = now.worldFromBody();
  const double keel = -hull_.draft();
  points_[0] = now.position;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    points_[i + 1] = now.position + glm::dvec2(worldFromBody * glm::dvec3(columns_[i].place, 0.0));
  }
  water.sample(points_, time_, samples_, {.derivatives = false, .excludeVessel = ownWake});
  waterHeight_ = samples_[0].height;
  submergedVolume_ = 0.0;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const double low = now.height + (worldFromBody * glm::dvec3(columns_[i].place, keel)).z;
    submergedVolume_ +=
        columns_[i].area * std::clamp(samples_[i + 1].height - low, 0.0, hull_.depth);
  }
}

double HostedVessel::speed() const {
  const CoursePoint ground = groundAt(time_);
  return glm::dot(ground.velocity, unitVector(ground.direction));
}

std::size_t HostedVessel::memoryBytes() const {
  return track_.memoryBytes() + poses_.size() * sizeof(TimedPose) +
         points_.size() * (sizeof(glm::dvec2) + sizeof(SurfaceSample));
}

}  // namespace seaway::bridge
