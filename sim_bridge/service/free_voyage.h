#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <string>
#include <vector>

#include "sim_bridge/vessel/vessel.h"

namespace seaway::bridge {

/// The free vessels of a served scene as they have sailed until `time`. Immutable once handed out.
struct FreeVoyage {
  struct TimedPose {
    double time = 0.0;
    VesselPose pose;
  };
  std::uint64_t number = 0;     ///< another one: begun anew from the epoch
  double time = 0.0;            ///< s
  std::vector<Vessel> vessels;  ///< the scene's, as they are in this voyage, with their pasts
  std::map<std::size_t, std::deque<TimedPose>> poses;  ///< by vessel, rising; of the free ones
  std::string fault;                                   ///< why it ends here; empty: it goes on

  /// Times that poses are known for go this far back, s.
  static constexpr double remembered = 30.0;

  double earliest() const;  ///< s
  bool covers(double t) const { return t >= earliest() && t <= time; }

  /// Between the two steps about `t`; the nearest known where it covers no such time.
  VesselPose poseAt(std::size_t vessel, double t) const;
};

}  // namespace seaway::bridge
