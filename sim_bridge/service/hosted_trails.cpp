#include "sim_bridge/service/hosted_trails.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace seaway::bridge {
namespace {

/// A move faster than this is no sailing, m/s, as PoseLog has it.
constexpr double fastest = 100.0;

constexpr std::size_t mostGone = 64;

}  // namespace

HostedTrails::Sailed HostedTrails::begun(std::size_t vessel, const WakePose& pose) {
  const CoursePoint place{pose.position, pose.heading, glm::dvec2(0.0)};
  Sailed sailed{vessel,    VesselTrack(Course(pose.position, pose.heading, 0.0, 0.0)),
                pose.time, pose.time,
                place,     std::nullopt};
  sailed.track.record(pose.time, place);
  return sailed;
}

void HostedTrails::record(Sailed& sailed, const WakePose& pose) {
  const double past = pose.time - sailed.latest;
  const glm::dvec2 moved = pose.position - sailed.last.position;
  if (glm::length(moved) > fastest * past) {
    sailed = begun(sailed.vessel, pose);  // its trail of before stays as far as it is left
    return;
  }
  sailed.last = {pose.position, pose.heading, moved / past};
  sailed.latest = pose.time;
  sailed.track.record(pose.time, sailed.last);
}

void HostedTrails::hear(const std::map<std::uint32_t, HullNews>& news) {
  for (const auto& [hull, each] : news) {
    if (each.begins) sailed_.erase(hull);
    for (const WakePose& pose : each.poses) {
      if (pose.time < 0.0) continue;
      const auto known = sailed_.find(hull);
      if (known != sailed_.end()) {
        record(known->second, pose);
      } else {
        sailed_.emplace(hull, begun(each.vessel, pose));
      }
    }
    if (!each.ends) continue;
    const auto known = sailed_.find(hull);
    if (known == sailed_.end()) continue;
    gone_.push_back(std::move(known->second));
    if (gone_.size() > mostGone) gone_.pop_front();
    sailed_.erase(known);
  }
}

void HostedTrails::leave(Sailed& sailed, double since, double t, SceneDetail& detail) const {
  const BoxHull& box = scene_->scene.vessels[sailed.vessel].model.hull;
  const double to = std::min(t, sailed.latest);
  const double from = std::max(sailed.leftUntil.value_or(sailed.begin), since);
  if (to <= from) return;
  sailed.leftUntil = detail.leaveTrail({.hull = {box.length, box.beam},
                                        .placeAt = [&](double at) { return sailed.track.at(at); },
                                        .from = from,
                                        .to = to});
}

void HostedTrails::leave(double since, double t, SceneDetail& detail) {
  for (auto& [hull, sailed] : sailed_) leave(sailed, since, t, detail);
  for (Sailed& sailed : gone_) leave(sailed, since, t, detail);
}

void HostedTrails::begin(double t) {
  std::erase_if(gone_, [=](const Sailed& sailed) { return sailed.latest > t; });
  for (auto& [hull, sailed] : sailed_) sailed.leftUntil.reset();
  for (Sailed& sailed : gone_) sailed.leftUntil.reset();
}

}  // namespace seaway::bridge
