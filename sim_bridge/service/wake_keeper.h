#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <vector>

#include "sim_bridge/service/free_voyage.h"
#include "sim_bridge/service/served_fleet.h"
#include "sim_bridge/service/served_scene.h"
#include "surface/disturbance/wake_system.h"

namespace seaway::bridge {

/// The wakes of a served scene: of hosts' hulls, and of vessels on the scene's own courses, which
/// have sailed before the epoch too. For one thread.
///
/// Times may go back: the courses' wakes are the same whenever they are asked for; a host's hull
/// whose last pose is more than five seconds before the time asked for leaves none.
class WakeKeeper {
 public:
  explicit WakeKeeper(std::shared_ptr<const ServedScene> scene);

  const ServedScene& scene() const { return *scene_; }
  std::shared_ptr<const Published<DisturbanceState>> feed() const { return system_.feed(); }
  std::shared_ptr<const DisturbanceState> latest() const { return system_.latest(); }
  std::size_t running() const { return system_.running(); }
  std::size_t memoryBytes() const { return system_.memoryBytes(); }

  void hear(const std::map<std::uint32_t, HullNews>& news);

  /// Wakes at `t` for those who listen. Vessels that `hosted` names are not on their courses.
  /// Free ones are where `voyage` has them, as far as it goes; null: nowhere.
  void advance(double t, std::span<const WakeListener> listeners, const std::vector<bool>& hosted,
               const FreeVoyage* voyage);
  /// Nobody listens: all windows are let go.
  void rest();

 private:
  struct OnCourse {
    bool begun = false;
    long long first = 0, last = 0;  // steps of the finest window that the log holds
    std::uint64_t voyage = 0;       // of a free vessel
  };
  struct OfHost {
    std::size_t vessel = 0;
    double latest = 0.0;  // time of the last pose, s
    bool begun = false;
  };
  void sail(std::size_t index, double t, const FreeVoyage* voyage);
  void leaveCourse(std::size_t index);
  void begin(std::uint32_t handle, std::size_t vessel);

  std::shared_ptr<const ServedScene> scene_;
  WakeSystem system_;
  std::vector<OnCourse> onCourse_;
  std::map<std::uint32_t, OfHost> ofHosts_;
  double time_ = 0.0;
};

}  // namespace seaway::bridge
