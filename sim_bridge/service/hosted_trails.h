#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "sim_bridge/scene_detail.h"
#include "sim_bridge/service/served_fleet.h"
#include "sim_bridge/service/served_scene.h"
#include "sim_bridge/vessel/vessel_track.h"

namespace seaway::bridge {

/// The trails of the hulls that hosts sail: foam and smoothed water along the poses that they have
/// submitted, whenever those come. For one thread.
///
/// A hull's past of 900 s is kept, and of the last 64 that are gone, so that trails can be left
/// anew where time goes back. Poses before the epoch leave none, and are
/// counted.
class HostedTrails {
 public:
  explicit HostedTrails(std::shared_ptr<const ServedScene> scene) : scene_(std::move(scene)) {}

  void hear(const std::map<std::uint32_t, HullNews>& news);

  /// Leaves on `detail` what hulls have left from `since` to `t`, s, and not yet there.
  void leave(double since, double t, SceneDetail& detail);
  /// Time has gone back to `t`: all is left anew on another detail, and what hulls that are gone
  /// have done after it never happened.
  void begin(double t);

  bool empty() const { return sailed_.empty() && gone_.empty(); }

 private:
  struct Sailed {
    std::size_t vessel = 0;
    VesselTrack track;
    double begin = 0.0, latest = 0.0;  ///< times of its first and its last pose, s
    CoursePoint last;
    std::optional<double> leftUntil;
  };
  static Sailed begun(std::size_t vessel, const WakePose& pose);
  static void record(Sailed& sailed, const WakePose& pose);
  void leave(Sailed& sailed, double since, double t, SceneDetail& detail) const;

  std::shared_ptr<const ServedScene> scene_;
  std::map<std::uint32_t, Sailed> sailed_;
  std::deque<Sailed> gone_;
};

}  // namespace seaway::bridge
