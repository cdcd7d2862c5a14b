#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "sim_bridge/service/free_voyage.h"
#include "sim_bridge/service/served_scene.h"
#include "sim_bridge/simulation.h"

namespace seaway::bridge {

/// Sails the free vessels of a served scene, as `seaway run` does (Simulation): in the scene's
/// steps from its epoch on, in each other's wakes and those of courses and of hulls that hosts
/// sail. Where no host changes anything their poses at the steps are a run's, bit for bit. For one
/// thread.
///
/// It has wakes of its own, near its vessels alone: those of the last step, which they feel. Of
/// several hulls that are one vessel of the scene it knows the first.
class FreeSailing {
 public:
  explicit FreeSailing(std::shared_ptr<const ServedScene> scene);

  const ServedScene& scene() const { return *scene_; }
  double time() const { return simulation_.time(); }
  double nextTime() const { return simulation_.nextTime(); }

  /// Other waves than the scene's from now on; null: the scene's.
  void setWaves(std::shared_ptr<const WaveField> waves);
  const std::shared_ptr<const WaveField>& waves() const { return waves_; }

  /// Where a host has a vessel at nextTime(); from then on it is a host's.
  void place(std::size_t vessel, const VesselPose& pose);
  /// Whether a vessel that was a host's is not among `hosted`: this voyage knows no way back.
  bool hasLost(const std::vector<bool>& hosted) const;
  /// To nextTime(); where a vessel cannot go on (aground, out of range) the voyage has a fault and
  /// ends.
  void step();
  bool hasEnded() const { return !fault_.empty(); }

  std::shared_ptr<const FreeVoyage> voyage() const;

 private:
  void note();

  std::shared_ptr<const ServedScene> scene_;
  std::shared_ptr<const WaveField> waves_;
  std::unique_ptr<Sea> sea_;  // with other waves
  Simulation simulation_;
  std::uint64_t number_;
  std::map<std::size_t, std::deque<FreeVoyage::TimedPose>> poses_;
  std::vector<bool> hosted_;
  std::string fault_;
};

}  // namespace seaway::bridge
