#include "sim_bridge/service/wake_keeper.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim_bridge/scene_wakes.h"
#include "sim_bridge/vessel/wake_footprint.h"

namespace seaway::bridge {
namespace {

/// A hull that has not been heard of for this long is of another clock, s.
constexpr double ofAnotherClock = 5.0;

/// Logs hold ten seconds more than waves last (WakeSystem): so far times may go back in them, s.
constexpr double remembered = 9.0;

/// Rounding of times that are meant to lie on the grid, in steps.
constexpr double onGrid = 1e-6;

}  // namespace

WakeKeeper::WakeKeeper(std::shared_ptr<const ServedScene> scene)
    : scene_(std::move(scene)),
      system_(wakeSettings(scene_->scene, scene_->sea)),
      onCourse_(scene_->vessels.size()) {}

void WakeKeeper::begin(std::uint32_t handle, std::size_t vessel) {
  system_.dropVessel(handle);
  system_.addVessel(handle, wakeFootprint(scene_->scene.vessels[vessel].model));
}

void WakeKeeper::hear(const std::map<std::uint32_t, HullNews>& news) {
  for (const auto& [handle, each] : news) {
    if (each.begins && each.vessel < scene_->vessels.size() &&
        scene_->vessels[each.vessel].canMakeWaves) {
      begin(handle, each.vessel);
      ofHosts_[handle] = {each.vessel, 0.0, true};
    }
    const auto hull = ofHosts_.find(handle);
    if (hull == ofHosts_.end()) continue;
    for (WakePose pose : each.poses) {
      if (!std::exchange(hull->second.begun, true)) begin(handle, hull->second.vessel);
      pose.immersion *= scene_->scene.vessels[hull->second.vessel].model.wake.strength;
      system_.record(handle, pose);
      hull->second.latest = pose.time;
    }
    if (!each.ends) continue;
    // Its waves go on until they are gone.
    if (hull->second.begun) system_.removeVessel(handle);
    ofHosts_.erase(hull);
  }
}

void WakeKeeper::leaveCourse(std::size_t index) {
  if (std::exchange(onCourse_[index].begun, false)) {
    system_.dropVessel(ServedScene::handleOf(index));
  }
}

void WakeKeeper::sail(std::size_t index, double t, const FreeVoyage* voyage) {
  const ServedVessel& vessel = scene_->vessels[index];
  const std::uint32_t handle = ServedScene::handleOf(index);
  OnCourse& log = onCourse_[index];
  const auto now = static_cast<long long>(std::floor(t / vessel.step + onGrid));
  const auto record = [&](long long step) {
    const double time = static_cast<double>(step) * vessel.step;
    if (voyage) {
      system_.record(handle,
                     wakePoseOf(time, scene_->scene.vessels[index], voyage->vessels[index]));
      return;
    }
    const CoursePoint place = vessel.course.at(time);
    system_.record(handle, {time, place.position, place.direction,
                            scene_->scene.vessels[index].model.wake.strength});
  };
  if (log.begun) {
    const auto memory = static_cast<long long>(system_.memory(handle) / vessel.step);
    if (now < log.first + memory ||
        now < log.last - static_cast<long long>(remembered / vessel.step) ||
        now > log.last + memory || (voyage && voyage->number != log.voyage)) {
      log.begun = false;
    }
  }
  if (!log.begun) {
    begin(handle, index);
    const auto memory = static_cast<long long>(system_.memory(handle) / vessel.step);
    log = {true, now - memory - 1, now - memory - 2, voyage ? voyage->number : 0};
  }
  while (log.last < now) record(++log.last);
}

void WakeKeeper::advance(double t, std::span<const WakeListener> listeners,
                         const std::vector<bool>& hosted, const FreeVoyage* voyage) {
  for (std::size_t i = 0; i < onCourse_.size(); ++i) {
    const ServedVessel& vessel = scene_->vessels[i];
    if (!vessel.makesWaves) continue;
    // A free vessel that is far behind has not yet been where it is now.
    const bool there = !vessel.free || (voyage && voyage->time >= t - ofAnotherClock);
    if (hosted[i] || !there) {
      leaveCourse(i);
    } else if (vessel.free) {
      sail(i, std::min(t, voyage->time), voyage);
    } else {
      sail(i, t, nullptr);
    }
  }
  for (auto& [handle, hull] : ofHosts_) {
    if (!hull.begun || hull.latest >= t - ofAnotherClock) continue;
    system_.dropVessel(handle);
    hull.begun = false;
  }
  system_.advance(t, listeners);
  time_ = t;
}

void WakeKeeper::rest() {
  if (system_.running() == 0) return;
  // Windows stay for five seconds after the last listener has left.
  system_.advance(time_ + 10.0, {});
}

}  // namespace seaway::bridge
