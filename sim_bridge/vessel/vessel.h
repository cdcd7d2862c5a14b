#pragma once

#include <utility>
#include <variant>

#include "sim_bridge/vessel/free_vessel.h"
#include "sim_bridge/vessel/hosted_vessel.h"
#include "sim_bridge/vessel/prescribed_vessel.h"

namespace seaway::bridge {

/// A vessel of a scene: on its prescribed course, free, or where a host has it. A value; a copy
/// moves on alone.
class Vessel {
 public:
  explicit Vessel(PrescribedVessel vessel) : kind_(std::move(vessel)) {}
  explicit Vessel(FreeVessel vessel) : kind_(std::move(vessel)) {}
  explicit Vessel(HostedVessel vessel) : kind_(std::move(vessel)) {}

  /// Null where it is of the other kind.
  PrescribedVessel* prescribed() { return std::get_if<PrescribedVessel>(&kind_); }
  const PrescribedVessel* prescribed() const { return std::get_if<PrescribedVessel>(&kind_); }
  FreeVessel* free() { return std::get_if<FreeVessel>(&kind_); }
  const FreeVessel* free() const { return std::get_if<FreeVessel>(&kind_); }
  HostedVessel* hosted() { return std::get_if<HostedVessel>(&kind_); }
  const HostedVessel* hosted() const { return std::get_if<HostedVessel>(&kind_); }

  double time() const {
    return std::visit([](const auto& vessel) { return vessel.time(); }, kind_);
  }
  VesselPose pose() const {
    return std::visit([](const auto& vessel) { return vessel.pose(); }, kind_);
  }
  /// Place and heading at `t`, now or before; of a free vessel see VesselTrack.
  CoursePoint placeAt(double t) const {
    return std::visit([=](const auto& vessel) { return vessel.placeAt(t); }, kind_);
  }
  double speed() const {  ///< over ground along the heading, negative astern, m/s
    return std::visit([](const auto& vessel) { return vessel.speed(); }, kind_);
  }
  double mass() const {  ///< kg
    return std::visit([](const auto& vessel) { return vessel.mass(); }, kind_);
  }
  double waterHeight() const {  ///< at the body origin, m
    return std::visit([](const auto& vessel) { return vessel.waterHeight(); }, kind_);
  }
  double submergedVolume() const {  ///< m³
    return std::visit([](const auto& vessel) { return vessel.submergedVolume(); }, kind_);
  }

 private:
  std::variant<PrescribedVessel, FreeVessel, HostedVessel> kind_;
};

}  // namespace seaway::bridge
