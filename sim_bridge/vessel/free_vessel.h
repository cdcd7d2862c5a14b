#pragma once

#include <cstddef>
#include <cstdint>

#include "sim_bridge/dynamics/hull_vessel.h"
#include "sim_bridge/vessel/vessel_pose.h"
#include "sim_bridge/vessel/vessel_track.h"

namespace seaway::bridge {

/// A scene's vessel free in all six degrees on its mesh (HullVessel), with what scenes ask of
/// vessels: a past, the water at it, a pose in the body frame of files.
///
/// Before the scene's epoch it has sailed the straight course that its start and speed give: its
/// waves and its trail of that time are those. Deterministic; a copy moves on alone.
class FreeVessel {
 public:
  /// `body` lies at its start at the scene's epoch, `before` leads there.
  FreeVessel(HullVessel body, const Course& before);

  /// Sets it down on the water at its start: at the mean height and slope of the water under it,
  /// rising with it. `ownWake` as LoadOptions::ownWake.
  void settle(const WaterSurface& water, std::uint32_t ownWake);

  /// Moves from time() to `t` > it in `water`.
  void advance(double t, const WaterSurface& water, std::uint32_t ownWake);

  /// Notes the water's height at the body origin now.
  void readWater(const WaterSurface& water, std::uint32_t ownWake);

  const HullVessel& body() const { return body_; }
  double time() const { return body_.time(); }
  VesselPose pose() const;
  /// Place and heading at a time: see VesselTrack.
  CoursePoint placeAt(double t) const { return track_.at(t); }
  double speed() const;  ///< over ground along the heading, negative astern, m/s
  double mass() const { return body_.hull().settings().mass; }
  double waterHeight() const { return waterHeight_; }          ///< m
  double submergedVolume() const { return submergedVolume_; }  ///< m³
  SampleStatus status() const { return status_; }  ///< of all loads of the last `advance`

  std::size_t memoryBytes() const;

  /// Writes or reads the state: see surface/state_archive.h.
  template <class Archive>
  void archive(Archive& archive);

 private:
  void notePlace();

  HullVessel body_;
  VesselTrack track_;
  double waterHeight_ = 0.0, submergedVolume_ = 0.0;
  SampleStatus status_ = SampleStatus::ok;
};

}  // namespace seaway::bridge
