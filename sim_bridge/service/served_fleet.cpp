#include "sim_bridge/service/served_fleet.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim_bridge/vessel/pose_between.h"

namespace seaway::bridge {
namespace {

/// A pose this much before the last means that the host has begun again, s.
constexpr double beganAgain = 1.0;
/// A hull goes on from its last pose for this long, s.
constexpr double reckoned = 0.5;
constexpr double reckonedFrom = 0.1;
constexpr std::size_t mostPoses = 256;
constexpr double trailInterval = 0.05;  // s
constexpr std::ptrdiff_t mostTrailNews = 9000;

WakePose wakePose(double t, const VesselPose& pose) {
  return {t, pose.position, pose.direction, 1.0};
}

}  // namespace

std::uint32_t ServedFleet::add(std::size_t vessel) {
  hulls_[++last_].vessel = vessel;
  return last_;
}

bool ServedFleet::remove(std::uint32_t hull) {
  if (hulls_.erase(hull) == 0) return false;
  news_[hull].ends = true;
  trailNews_[hull].ends = true;
  return true;
}

bool ServedFleet::place(std::uint32_t hull, double t, const VesselPose& pose) {
  const auto found = hulls_.find(hull);
  if (found == hulls_.end()) return false;
  Hull& placed = found->second;
  const bool again = placed.isPlaced() && t < placed.poses.back().time - beganAgain;
  if (placed.isPlaced() && !again && t <= placed.poses.back().time) return false;
  HullNews& news = news_[hull];
  if (again) {
    placed.poses.clear();
    news.poses.clear();
  }
  if (!placed.isPlaced()) {
    news.begins = true;
    news.vessel = placed.vessel;
  } else {
    const VesselPose& last = placed.poses.back().pose;
    placed.moved =
        placed.moved || last.position != pose.position || last.direction != pose.direction;
  }
  placed.poses.push_back({t, pose});
  if (placed.poses.size() > mostPoses) placed.poses.pop_front();
  news.poses.push_back(wakePose(t, pose));
  tellTrail(hull, placed, placed.poses.size() == 1);
  return true;
}

std::optional<VesselPose> ServedFleet::at(std::uint32_t hull, double t) const {
  const auto found = hulls_.find(hull);
  if (found == hulls_.end() || !found->second.isPlaced()) return std::nullopt;
  const auto& poses = found->second.poses;
  const auto next =
      std::upper_bound(poses.begin(), poses.end(), t,
                       [](double time, const auto& each) { return time < each.time; });
  if (next == poses.begin()) return poses.front().pose;
  const auto& last = *(next - 1);
  if (next != poses.end()) {
    return poseBetween(last.pose, next->pose, (t - last.time) / (next->time - last.time));
  }
  // Reckoned from a pose some time back, lest the noise of two close ones be blown up.
  auto before = next - 1;
  while (before != poses.begin() && before->time > last.time - reckonedFrom) --before;
  if (before == next - 1) return last.pose;
  const double on = std::min(t - last.time, reckoned);
  VesselPose pose = poseBetween(before->pose, last.pose, 1.0 + on / (last.time - before->time));
  pose.height = last.pose.height;
  pose.pitch = last.pose.pitch;
  pose.roll = last.pose.roll;
  return pose;
}

void ServedFleet::renumber(const std::vector<std::optional<std::size_t>>& vessels) {
  std::erase_if(hulls_, [&](const auto& entry) { return !vessels[entry.second.vessel]; });
  for (auto& [number, hull] : hulls_) hull.vessel = *vessels[hull.vessel];
}

std::map<std::uint32_t, HullNews> ServedFleet::allNews() const {
  std::map<std::uint32_t, HullNews> all;
  for (const auto& [number, hull] : hulls_) {
    if (!hull.isPlaced()) continue;
    HullNews& news = all[number];
    news.vessel = hull.vessel;
    news.begins = true;
    for (const auto& each : hull.poses) news.poses.push_back(wakePose(each.time, each.pose));
  }
  return all;
}

// After its pose is noted.
void ServedFleet::tellTrail(std::uint32_t number, Hull& hull, bool begins) {
  const auto& [t, pose] = hull.poses.back();
  if (!begins && t < hull.trailTold + trailInterval) return;
  HullNews& news = trailNews_[number];
  if (begins) news = HullNews();
  news.begins = news.begins || begins;
  news.vessel = hull.vessel;
  news.poses.push_back(wakePose(t, pose));
  // Nobody has asked for long.
  if (std::ssize(news.poses) > 2 * mostTrailNews) {
    news.poses.erase(news.poses.begin(), news.poses.begin() + mostTrailNews);
  }
  hull.trailTold = t;
}

}  // namespace seaway::bridge
