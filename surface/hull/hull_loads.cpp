#include "surface/hull/hull_loads.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "surface/hull/load_work.h"

namespace seaway {
namespace {

bool isFinite(const glm::dvec3& v) { return std::isfinite(v.x + v.y + v.z); }

bool isFinite(const HullPose& pose) {
  const glm::dquat& q = pose.worldFromBody;
  return isFinite(pose.position) && isFinite(pose.velocity) && isFinite(pose.angularVelocity) &&
         std::isfinite(q.w + q.x + q.y + q.z);
}

Load notFinite() {
  const glm::dvec3 nan(std::numeric_limits<double>::quiet_NaN());
  return {nan, nan};
}

HullLoads unknown(SampleStatus status) {
  HullLoads result;
  result.buoyancy = result.drag = result.radiation = result.wind = notFinite();
  result.waterAcceleration = glm::dvec3(std::numeric_limits<double>::quiet_NaN());
  result.status = status;
  return result;
}

}  // namespace

/// Linear damping of motion relative to the water, which rises by its mean over the hull and turns
/// with its tilt along and across it.
void LoadWork::radiate() {
  const double share = std::min(1.0, sums.volume / hull.atRest().volume);
  for (std::size_t i = 0; i < 6; ++i) result.addedMass[i] = share * hull.addedMass()[i];
  const glm::dvec3& damping = hull.damping();
  double mean = 0.0, pitching = 0.0, rolling = 0.0, xx = 0.0, yy = 0.0;
  const glm::dvec3 middle = hull.bounds().middle();
  for (std::size_t i = 0; i < rise.size(); ++i) {
    const glm::dvec3 arm = hull.probePlaces()[i] - middle;
    mean += rise[i] / double(HullModel::probes);
    pitching += arm.x * rise[i];
    rolling += arm.y * rise[i];
    xx += arm.x * arm.x;
    yy += arm.y * arm.y;
  }
  const glm::dvec3& gravity = hull.settings().centreOfGravity;
  const glm::dvec3 current(water.waves().field().settings().current, 0.0);
  const glm::dvec3 own = velocity + glm::cross(turning, gravity);
  const glm::dvec3 carried = bodyFromWorld * (current + glm::dvec3(0.0, 0.0, mean));
  const glm::dvec3 force(0.0, 0.0, -share * damping.x * (own.z - carried.z));
  // Water that rises forward turns the bow up: about −y.
  const glm::dvec3 couple(-share * damping.y * (turning.x - rolling / yy),
                          -share * damping.z * (turning.y + pitching / xx), 0.0);
  result.radiation = {worldFromBody * force, worldFromBody * (couple + glm::cross(gravity, force))};
}

HullLoads LoadWork::finish() {
  const auto inWorld = [&](const Load& load, double factor) {
    return Load{worldFromBody * (factor * load.force), worldFromBody * (factor * load.moment)};
  };
  result.buoyancy = inWorld(sums.buoyancy, hull.volumeFactor());
  result.drag = inWorld(sums.drag, 1.0);
  result.wind = inWorld(sums.wind, 1.0);
  result.submergedVolume = hull.volumeFactor() * sums.volume;
  result.wettedArea = sums.wetted;
  return result;
}

HullLoads loads(const HullModel& hull, const HullPose& pose, const SurfaceAtTime& water,
                LoadScratch& scratch, const LoadOptions& options) {
  if (!isFinite(pose) || !std::isfinite(water.time())) return unknown(SampleStatus::notFinite);
  LoadWork work(hull, pose, water, scratch, options);
  if (!work.probeWater()) return unknown(work.result.status);
  if (hull.settings().level == LoadLevel::columns) {
    work.pushColumns();
    if (work.flows) work.dragColumns();
  } else {
    if (!work.submergeVertices()) return unknown(work.result.status | SampleStatus::belowBed);
    work.pressPanels();
  }
  work.radiate();
  return work.finish();
}

HullLoads loads(const HullModel& hull, const HullPose& pose, const WaterSurface& water, double t,
                LoadScratch& scratch, const LoadOptions& options) {
  if (scratch.water_) {
    scratch.water_->moveTo(water, t);
  } else {
    scratch.water_.emplace(water.at(t));
  }
  return loads(hull, pose, *scratch.water_, scratch, options);
}

void loadsInParallel(std::span<const PlacedHull> hulls, const SurfaceAtTime& water,
                     std::span<HullLoads> out, std::span<LoadScratch> scratch) {
  tbb::parallel_for(std::size_t{0}, hulls.size(), [&](std::size_t i) {
    out[i] = loads(*hulls[i].model, hulls[i].pose, water, scratch[i], hulls[i].options);
  });
}

std::size_t LoadScratch::memoryBytes() const {
  return (x_.capacity() + y_.capacity() + depth_.capacity() + pressure_.capacity()) *
             sizeof(double) +
         (height_.capacity() + slopeX_.capacity() + slopeY_.capacity() + stretched_.capacity() +
          head_.capacity()) *
             sizeof(float) +
         change_.capacity() * sizeof(float) + place_.capacity() * sizeof(glm::dvec2) +
         wet_.capacity() * sizeof(std::uint32_t);
}

}  // namespace seaway
