#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "sim_bridge/dynamics/propulsion.h"

namespace seaway::bridge {

/// Steers a vessel along waypoints and keeps its speed.
struct AutopilotSettings {
  std::vector<glm::dvec2> waypoints;  ///< sea plane, m; after the last, its last leg goes on
  double speed = 0.0;                 ///< through the water, m/s
  double shipLength = 10.0;           ///< m: sets look-ahead and how near a waypoint is reached
  double headingGain = 1.5;           ///< rudder per heading error
  double dampingTime = 0.0;           ///< rudder per rate of turn, s; 0: 0.6 L/speed
};

/// Line-of-sight guidance (Fossen 2011, 10.3): heads for a point `lookAhead` = 4 lengths down the
/// leg from where the vessel is nearest to it; the next leg begins within 3 lengths of a waypoint
/// or once it is abeam. Heading by a proportional-differential law, speed by a
/// proportional-integral one. Legs are straight in the sea plane: geodesics to its scale error.
/// Deterministic.
class Autopilot {
 public:
  /// What it sees of the vessel.
  struct View {
    glm::dvec2 position{0.0};
    double direction = 0.0;  ///< of the bow, rad counter-clockwise from east
    double turnRate = 0.0;   ///< rad/s, counter-clockwise
    double speed = 0.0;      ///< through the water along the bow, m/s
  };

  /// Begins at `start`; its first leg is from there to the first waypoint.
  Autopilot(const AutopilotSettings& settings, glm::dvec2 start);

  Helm steer(const View& view, double dt, const Propeller& propeller, const Rudder& rudder);

  std::size_t nextWaypoint() const { return next_; }
  /// Distance from the leg, positive to port of it, m; 0 without waypoints.
  double crossTrack(glm::dvec2 position) const;

  /// Writes or reads the state: see surface/state_archive.h.
  template <class Archive>
  void archive(Archive& archive);

 private:
  glm::dvec2 legStart() const;
  glm::dvec2 legEnd() const;

  AutopilotSettings settings_;
  glm::dvec2 start_;
  std::size_t next_ = 0;
  double revolutions_ = 0.0;  // integral part
};

}  // namespace seaway::bridge
