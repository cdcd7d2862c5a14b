#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <glm/vec2.hpp>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "sim_bridge/vessel/vessel.h"
#include "surface/disturbance/wake_listener.h"

namespace seaway::bridge {

/// What the wakes have to hear about a hull.
struct HullNews {
  std::size_t vessel = 0;
  bool begins = false;  ///< new, or its host has gone back in time: what was before never happened
  bool ends = false;
  std::vector<WakePose> poses;  ///< by rising time; immersion 1
};

/// The hulls that hosts sail, in the sea plane. Not thread-safe.
///
/// A hull is where its host said, between two poses in between; after the last it goes on for half
/// a second and then rests there: hosts' clocks are not each other's.
class ServedFleet {
 public:
  /// A hull's number, above 0.
  std::uint32_t add(std::size_t vessel);
  bool remove(std::uint32_t hull);
  bool has(std::uint32_t hull) const { return hulls_.contains(hull); }
  std::size_t size() const { return hulls_.size(); }

  /// False, and nothing changes, for an unknown hull and a pose that is not later than the last;
  /// more than a second before it the host has begun again.
  bool place(std::uint32_t hull, double t, const VesselPose& pose);

  /// Where a hull is at `t`; nothing before its host has said.
  std::optional<VesselPose> at(std::uint32_t hull, double t) const;

  struct Hull {
    std::size_t vessel = 0;
    bool moved = false;      ///< has ever been in two places
    double trailTold = 0.0;  ///< time of the last pose that trails have heard of, s
    struct TimedPose {
      double time = 0.0;
      VesselPose pose;
    };
    std::deque<TimedPose> poses;  ///< the last few, by rising time
    bool isPlaced() const { return !poses.empty(); }
  };
  const std::map<std::uint32_t, Hull>& hulls() const { return hulls_; }

  /// Hulls take new numbers of vessels, by their old ones; those of vessels without one go.
  void renumber(const std::vector<std::optional<std::size_t>>& vessels);

  /// What has happened since the last call, by hull.
  std::map<std::uint32_t, HullNews> takeNews() { return std::exchange(news_, {}); }
  /// All hulls begin anew: for wakes that know nothing yet.
  void retell() { news_ = allNews(); }

  /// The same for their trails, with a pose for each 0.05 s.
  std::map<std::uint32_t, HullNews> takeTrailNews() { return std::exchange(trailNews_, {}); }
  void retellTrails() { trailNews_ = allNews(); }

 private:
  std::map<std::uint32_t, Hull> hulls_;
  std::map<std::uint32_t, HullNews> allNews() const;
  void tellTrail(std::uint32_t number, Hull& hull, bool begins);

  std::map<std::uint32_t, HullNews> news_, trailNews_;
  std::uint32_t last_ = 0;
};

}  // namespace seaway::bridge
