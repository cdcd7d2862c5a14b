#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "surface/hull/load_work.h"

namespace seaway {

/// ρg A ℓ (−∇η, 1) at the middle of a column's wet length ℓ: pressure grows along the surface's
/// normal, to first order for waves longer than the hull is deep.
void LoadWork::pushColumns() {
  const auto& columns = hull.columns();
  resize(columns.size(), true);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const glm::dvec3 place =
        pose.position + worldFromBody * glm::dvec3(columns[i].place, -hull.restHeight());
    scratch.x_[i] = place.x;
    scratch.y_[i] = place.y;
  }
  sampleHeights();
  tellShore();
  const glm::dvec3 up = worldFromBody[2];
  const double steepness = std::max(std::abs(up.z), 1e-3);  // height of a column per metre of it
  const double bed = -water.waves().field().settings().depth;
  const TerrainMap* terrain = water.terrain();
  Load world;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const MeshColumn& column = columns[i];
    const double lowEnd = up.z >= 0.0 ? column.low : column.high;
    const glm::dvec3 low = worldFromBody * glm::dvec3(column.place, lowEnd);
    const double under = scratch.height_[i] - (pose.position.z + low.z);
    const double wet = std::clamp(under / steepness, 0.0, column.high - column.low);
    const double volume = column.area * wet;
    const double ground = terrain ? terrain->heightAt({scratch.x_[i], scratch.y_[i]}) : bed;
    if (pose.position.z + low.z < std::max(bed, ground)) result.status |= SampleStatus::belowBed;
    const glm::dvec3 arm = low + (up.z >= 0.0 ? 0.5 : -0.5) * wet * up;
    const glm::dvec3 force =
        waterWeight * volume * glm::dvec3(-scratch.slopeX_[i], -scratch.slopeY_[i], 1.0);
    world.force += force;
    world.moment += glm::cross(arm, force);
    sums.volume += volume;
  }
  sums.buoyancy = {bodyFromWorld * world.force, bodyFromWorld * world.moment};
}

/// Drag on the sides of the box about the wet part, with the mean flow.
void LoadWork::dragColumns() {
  const HullCoefficients& c = hull.settings().coefficients;
  const glm::dvec3 size = hull.bounds().size();
  const double draft =
      std::min(size.z, sums.volume / std::max(hull.atRest().waterplaneArea, 1e-300));
  glm::dvec3 mean(0.0);
  for (const glm::dvec3& each : flow) mean += each / double(HullModel::probes);
  const glm::dvec3 u = velocity - mean;
  const glm::dvec3 sides(size.y * draft, size.x * draft, hull.atRest().waterplaneArea);
  const double wetted = draft > 0.0 ? hull.atRest().wettedArea : 0.0;
  const glm::dvec3 force =
      -0.5 * seaWaterDensity *
      (2.0 * c.formDrag * sides * glm::abs(u) * u + friction * wetted * glm::length(u) * u);
  sums.drag = {force, glm::cross(hull.atRest().centre, force)};
}

}  // namespace seaway
