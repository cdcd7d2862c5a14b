#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>

#include "sim_bridge/dynamics/autopilot.h"
#include "sim_bridge/dynamics/propulsion.h"
#include "surface/hull/hull_loads.h"

namespace seaway::bridge {

/// Motion of a vessel's centre of gravity.
struct RigidMotion {
  glm::dvec3 position{0.0};                      ///< of the centre of gravity, sea plane, m
  glm::dquat worldFromBody{1.0, 0.0, 0.0, 0.0};  ///< unit
  glm::dvec3 velocity{0.0};                      ///< sea plane, m/s
  glm::dvec3 turning{0.0};                       ///< body frame, rad/s
};

struct HullVesselSettings {
  Propeller propeller;
  Rudder rudder;
  LoadOptions loads;
};

/// A hull free in all six degrees, for demonstrations without a physics engine.
///
/// Kirchhoff's equations of a rigid body with diagonal added mass that moves with the water's
/// acceleration and the current (Fossen 2011, 6.1). Semi-implicit Euler: velocities first, with
/// the forces of the present state, then position and attitude with the new velocities (the
/// exponential map keeps the quaternion's length). Sub-steps of at most 0.1 rad of the fastest of
/// heave, roll and pitch, water and loads anew at each: stable for any outer step, frequencies
/// within 0.1 %. Boost.Odeint has no stepper that is symplectic for attitudes and forces that
/// depend on velocity, and its Runge–Kutta steppers gain energy at long steps: hence this one.
///
/// Deterministic; allocates nothing once warm.
class HullVessel {
 public:
  /// `hull` sets mass, centre of gravity and gyradii. At rest upright at its draft, its origin
  /// above (0, 0), bow to the east.
  HullVessel(std::shared_ptr<const HullModel> hull, const HullVesselSettings& settings = {});

  const HullModel& hull() const { return *hull_; }
  const RigidMotion& motion() const { return motion_; }
  void setMotion(const RigidMotion& motion) { motion_ = motion; }
  /// Places the body's origin at rest at its draft over a point of the sea plane.
  void place(glm::dvec2 position, double direction, double speed);

  HullPose pose() const;  ///< of the body's origin
  double time() const { return time_; }
  void setTime(double time) { time_ = time; }

  void setHelm(const Helm& helm) { helm_ = helm; }
  const Helm& helm() const { return helm_; }
  double rudderAngle() const { return rudder_; }  ///< as it stands, rad
  void setAutopilot(const AutopilotSettings& settings);
  const std::optional<Autopilot>& autopilot() const { return autopilot_; }

  /// As LoadOptions::ownWake, from now on.
  void setOwnWake(std::uint32_t handle) { settings_.loads.ownWake = handle; }

  /// Moves from time() to `t` ≥ it.
  void advance(double t, const WaterSurface& water);

  const HullLoads& lastLoads() const { return loads_; }
  /// All that loads have told since the last clearStatus.
  SampleStatus status() const { return status_; }
  void clearStatus() { status_ = SampleStatus::ok; }
  /// ½ v·(m v) + ½ ω·(I ω) + m g z, J; added mass not counted.
  double energy() const;
  /// Sub-steps that `advance` makes of an interval of `dt` s.
  int subSteps(double dt) const;
  /// Bytes it holds; the hull, which others may share, included.
  std::size_t memoryBytes() const { return hull_->memoryBytes() + scratch_.memoryBytes(); }

  /// Writes or reads the state: see surface/state_archive.h.
  template <class Archive>
  void archive(Archive& archive);

 private:
  void subStep(double dt, const WaterSurface& water);
  void steer(double dt, const glm::dvec3& speed);
  /// Part of the screw's disc, its middle at `place`, that is under water.
  double immersionOf(const Propeller& screw, const glm::dvec3& place,
                     const WaterSurface& water) const;
  glm::dvec3 inertia() const;

  std::shared_ptr<const HullModel> hull_;
  HullVesselSettings settings_;
  RigidMotion motion_;
  Helm helm_;
  double rudder_ = 0.0, time_ = 0.0;
  std::optional<Autopilot> autopilot_;
  HullLoads loads_;
  LoadScratch scratch_;
  SampleStatus status_ = SampleStatus::ok;
};

}  // namespace seaway::bridge
