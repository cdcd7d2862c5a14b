#include "sim_bridge/capi/prepared_water.h"

#include <optional>

namespace seaway::bridge::capi {
namespace {

const WaterSurface& calm() {
  static const WaterSurface surface{WaveField({})};
  return surface;
}

SurfaceAtTime& threadsWater() {
  thread_local SurfaceAtTime water = calm().at(0.0);
  return water;
}

}  // namespace

PreparedWater::PreparedWater(const CoupledSea& sea, double t)
    : moment_(sea.now()), water_(&threadsWater()) {
  water_->moveTo(moment_->surface, t);
}

// The thread's memory must not keep a sea's wakes and layers when that sea has gone.
PreparedWater::~PreparedWater() {
  const SurfaceExtras& extras = water_->extras();
  if (water_->disturbances() || extras.events || extras.detail) water_->moveTo(calm(), 0.0);
}

PlanePlacer& placerOf(const CoupledSea& sea) {
  thread_local std::optional<PlanePlacer> placer;
  thread_local std::uint64_t number = 0;
  if (!placer || number != sea.number()) {
    placer.emplace(sea.geodesy());
    number = sea.number();
  }
  return *placer;
}

}  // namespace seaway::bridge::capi
