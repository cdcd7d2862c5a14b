#pragma once

#include <cmath>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "sim_bridge/vessel/box_hull.h"
#include "sim_bridge/vessel/course.h"
#include "sim_bridge/vessel/vessel_pose.h"
#include "surface/surface_sample.h"

namespace seaway::bridge {

/// A box that follows a prescribed course and heaves, rolls and pitches on the sea.
///
/// Each column of the hull is pushed up by ρg times its wet volume at its wet part's centre, and
/// down the water's slope by as much as the slope: pressure grows along the surface's normal (to
/// first order, for waves longer than the hull is deep), which makes hulls lie along long waves
/// wherever their centre of gravity is. Linear damping acts on motion relative to the water, so
/// that long waves carry the hull along without lag. Surge, sway and yaw are prescribed; added mass
/// is not modelled; moments are taken with small roll and pitch rates in mind (no gyroscopic
/// terms). Water reaches the hull through samples that the caller takes: once a step, at
/// `samplePoints`.
///
/// Integrated by semi-implicit Euler with implicit damping on sub-steps of at most 0.1/ω of the
/// fastest natural frequency, over water interpolated linearly between the steps' samples:
/// frequencies are right within 0.2 % (tests/sim_bridge/vessel/prescribed_vessel_test.cpp).
/// Deterministic.
class PrescribedVessel {
 public:
  PrescribedVessel(const BoxHull& hull, const Course& course);

  const BoxHull& hull() const { return hull_; }

  /// Number of points that samplePoints writes: the body origin, then the columns.
  std::size_t sampleCount() const { return columns_.size() + 1; }

  /// Where the water is to be sampled for time `t`, sea plane, m.
  void samplePoints(double t, std::span<glm::dvec2> out) const;

  /// Sets the vessel down on the water sampled at its start: at rest on still water, on waves with
  /// the mean height, slope and velocity of the water under it.
  void settle(double t, std::span<const SurfaceSample> water);

  /// Moves from the present time to `t` ≥ it; `water` was sampled at samplePoints(t).
  void advance(double t, std::span<const SurfaceSample> water);

  /// As `advance`, but the vessel stays upright at the still-water level (motion switched off).
  void advanceUpright(double t, std::span<const SurfaceSample> water);

  /// Displaces the vessel from where it lies: for decay tests. Metres and radians.
  void displace(double heave, double roll, double pitch);

  /// The current, m/s: damping acts on motion relative to it.
  void setCurrent(glm::dvec2 current) { current_ = current; }

  const Course& course() const { return course_; }
  CoursePoint placeAt(double t) const { return course_.at(t); }
  double mass() const { return hull_.mass(); }  ///< kg
  double time() const { return time_; }
  VesselPose pose() const;
  double speed() const { return course_.speed(); }     ///< over ground, negative astern, m/s
  double waterHeight() const { return waterHeight_; }  ///< at the body origin, m
  double submergedVolume() const { return submergedVolume_; }  ///< m³

  /// Writes or reads the state: see surface/state_archive.h.
  template <class Archive>
  void archive(Archive& archive);

 private:
  struct Motion {
    double value = 0.0;
    double rate = 0.0;
  };
  struct Loads {
    double force = 0.0;   // upward, N
    double roll = 0.0;    // starboard down, N·m
    double pitch = 0.0;   // bow up, N·m
    double volume = 0.0;  // m³
  };
  /// Motion of the water that damping is relative to.
  struct Flow {
    double heave = 0.0;
    double roll = 0.0;
    double pitch = 0.0;
  };

  void takeWater(std::span<const SurfaceSample> water);
  Loads buoyancy(double direction, double part) const;
  Flow flow(const CoursePoint& course, double part) const;
  void subStep(double t, double dt, double part);

  BoxHull hull_;
  Course course_;
  std::vector<HullColumn> columns_;
  double secondMomentAlong_ = 0.0;   // Σ A x², m⁴
  double secondMomentAcross_ = 0.0;  // Σ A y², m⁴
  glm::dvec2 current_{0.0};

  double time_ = 0.0;
  Motion heave_, roll_, pitch_;
  std::vector<SurfaceSample> waterBefore_, waterAfter_;  // at the columns
  double waterHeight_ = 0.0;
  double submergedVolume_ = 0.0;
};

}  // namespace seaway::bridge
