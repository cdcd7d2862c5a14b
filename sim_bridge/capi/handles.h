#pragma once

#include <memory>

#include "sim_bridge/capi/calls.h"
#include "sim_bridge/capi/coupled_sea.h"
#include "surface/hull/hull_model.h"

/// What the handles of the C interface point at. The types themselves are never defined, so that
/// nothing of them can become a part of the binary interface.
namespace seaway::bridge::capi {

using HullHandle = std::shared_ptr<const HullModel>;

inline const CoupledSea& seaOf(const seaway_sea* sea) {
  require(sea, "sea");
  return *reinterpret_cast<const CoupledSea*>(sea);
}
inline CoupledSea& seaOf(seaway_sea* sea) {
  require(sea, "sea");
  return *reinterpret_cast<CoupledSea*>(sea);
}
inline const HullModel& hullOf(const seaway_hull* hull) {
  require(hull, "hull");
  return **reinterpret_cast<const HullHandle*>(hull);
}

/// Throws CallError SEAWAY_NOT_FOUND unless the scene has a vessel of that number.
inline void requireVessel(const CoupledSea& sea, std::size_t vessel) {
  const std::size_t count = sea.scene().vessels.size();
  if (vessel < count) return;
  throw CallError(SEAWAY_NOT_FOUND, "there is no vessel " + std::to_string(vessel) +
                                        "; the scene has " + std::to_string(count));
}

/// Handle of the wake that options leave out: vessel number + 1, 0 for none. Throws CallError.
inline std::uint32_t excludedWake(const CoupledSea& sea, const CoupledSea::Moment& moment,
                                  std::uint32_t ownVessel) {
  if (ownVessel == 0) return 0;
  requireVessel(sea, ownVessel - 1);
  return moment.ownWakes[ownVessel - 1];
}

}  // namespace seaway::bridge::capi
