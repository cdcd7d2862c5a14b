#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "sim_bridge/vessel/box_hull.h"
#include "sim_bridge/vessel/vessel_pose.h"
#include "sim_bridge/vessel/vessel_track.h"
#include "surface/water_surface.h"

namespace seaway::bridge {

/// A scene's vessel that a host simulator sails: it is where the host says.
///
/// Between two poses it lies on the straight line between them; a move faster than 100 m/s is a
/// jump at its end. After the last pose it goes on as before for a second, then rests. Its past is
/// that of the vessel it was, then the host's. Deterministic; a copy moves on alone.
class HostedVessel {
 public:
  /// From time `t` on; `now` is where it lies then, `before` has the places until then.
  HostedVessel(const BoxHull& hull, double t, const VesselPose& now, VesselTrack before);

  /// The host's pose at `t`. False, and nothing changes, where that is before time() or not later
  /// than the last.
  bool place(double t, const VesselPose& pose);

  /// Moves from time() to `t` > it.
  void moveTo(double t);
  /// Notes the water at it now, of which the wake `ownWake` is not felt.
  void readWater(const WaterSurface& water, std::uint32_t ownWake);

  double time() const { return time_; }
  VesselPose pose() const { return at(time_); }
  /// Place and heading at a time: see VesselTrack.
  CoursePoint placeAt(double t) const { return track_.at(t); }
  double speed() const;  ///< over ground along the heading, negative astern, m/s
  double mass() const { return hull_.mass(); }
  double waterHeight() const { return waterHeight_; }          ///< at the body origin, m
  double submergedVolume() const { return submergedVolume_; }  ///< of the box, m³

  std::size_t memoryBytes() const;

 private:
  struct TimedPose {
    double time;
    VesselPose pose;
  };
  VesselPose at(double t) const;
  CoursePoint groundAt(double t) const;

  BoxHull hull_;
  std::vector<HullColumn> columns_;
  double time_;
  std::deque<TimedPose> poses_;  // rising; the first two may be before `time_`
  bool placed_ = false;
  VesselTrack track_;
  double waterHeight_ = 0.0, submergedVolume_ = 0.0;
  std::vector<glm::dvec2> points_;
  std::vector<SurfaceSample> samples_;
};

}  // namespace seaway::bridge
