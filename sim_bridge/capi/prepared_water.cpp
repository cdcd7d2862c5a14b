#include "sim_bridge/capi/prepared_water.h"

#include <optional>

namespace seaway::bridge::capi {
namespace {

PreparedSurface& threadsWater() {
  thread_local PreparedSurface water;
  return water;
}

}  // namespace

PreparedWater::PreparedWater(const CoupledSea& sea, double t)
    : moment_(sea.now()), water_(threadsWater(), {moment_, &moment_->surface}, t) {}

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
