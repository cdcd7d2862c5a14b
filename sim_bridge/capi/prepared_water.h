#pragma once

#include <memory>

#include "sim_bridge/capi/coupled_sea.h"
#include "sim_bridge/service/plane_placer.h"
#include "sim_bridge/service/prepared_surface.h"

namespace seaway::bridge::capi {

/// A sea's surface prepared for a time in memory that the calling thread keeps: allocates at the
/// thread's first call alone. One at a time a thread.
class PreparedWater {
 public:
  PreparedWater(const CoupledSea& sea, double t);

  const SurfaceAtTime& water() const { return *water_; }
  const CoupledSea::Moment& moment() const { return *moment_; }

 private:
  std::shared_ptr<const CoupledSea::Moment> moment_;
  PreparedSurface::Use water_;
};

/// The calling thread's placer of geodetic points for a sea; knows places that it met before.
PlanePlacer& placerOf(const CoupledSea& sea);

}  // namespace seaway::bridge::capi
