#include "sim_bridge/service/free_sailing.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <atomic>
#include <utility>

#include "sim_bridge/vessel/pose_between.h"

namespace seaway::bridge {
namespace {

std::uint64_t nextNumber() {
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}

}  // namespace

double FreeVoyage::earliest() const {
  return poses.empty() || poses.begin()->second.empty() ? time : poses.begin()->second.front().time;
}

VesselPose FreeVoyage::poseAt(std::size_t vessel, double t) const {
  const auto known = poses.find(vessel);
  if (known == poses.end() || known->second.empty()) return vessels[vessel].pose();
  const auto& all = known->second;
  const auto next = std::lower_bound(all.begin(), all.end(), t,
                                     [](const auto& each, double at) { return each.time < at; });
  if (next == all.begin()) return all.front().pose;
  if (next == all.end()) return all.back().pose;
  if (next->time == t) return next->pose;
  const auto& before = *(next - 1);
  return poseBetween(before.pose, next->pose, (t - before.time) / (next->time - before.time));
}

FreeSailing::FreeSailing(std::shared_ptr<const ServedScene> scene)
    : scene_(std::move(scene)),
      simulation_(scene_->scene, scene_->sea),
      number_(nextNumber()),
      hosted_(scene_->vessels.size()) {
  note();
}

void FreeSailing::setWaves(std::shared_ptr<const WaveField> waves) {
  std::unique_ptr<Sea> sea;
  if (waves) {
    const Sea& own = scene_->sea;
    sea = std::make_unique<Sea>(Sea{own.geodesy, SeaLevel(scene_->scene.sea.waterLevel),
                                    withWaves(own.surface, *waves), own.hm0Asked, own.blocked});
  }
  simulation_.setSea(sea ? *sea : scene_->sea);
  sea_ = std::move(sea);
  waves_ = std::move(waves);
}

void FreeSailing::place(std::size_t vessel, const VesselPose& pose) {
  hosted_[vessel] = simulation_.place(vessel, nextTime(), pose) || hosted_[vessel];
}

bool FreeSailing::hasLost(const std::vector<bool>& hosted) const {
  for (std::size_t i = 0; i < hosted_.size(); ++i) {
    if (hosted_[i] && !hosted[i]) return true;
  }
  return false;
}

void FreeSailing::step() {
  try {
    simulation_.step();
    note();
  } catch (const std::exception& fault) {
    fault_ = fault.what();
    spdlog::error("free vessels stand still: {}", fault_);
  }
}

void FreeSailing::note() {
  const auto vessels = simulation_.vessels();
  for (std::size_t i = 0; i < vessels.size(); ++i) {
    if (!scene_->vessels[i].free) continue;
    auto& all = poses_[i];
    all.push_back({time(), vessels[i].pose()});
    while (all.front().time < time() - FreeVoyage::remembered) all.pop_front();
  }
}

std::shared_ptr<const FreeVoyage> FreeSailing::voyage() const {
  auto voyage = std::make_shared<FreeVoyage>();
  voyage->number = number_;
  voyage->time = time();
  voyage->vessels.assign(simulation_.vessels().begin(), simulation_.vessels().end());
  voyage->poses = poses_;
  voyage->fault = fault_;
  return voyage;
}

}  // namespace seaway::bridge
