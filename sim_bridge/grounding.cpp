#include "sim_bridge/grounding.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace seaway::bridge {

InputError aground(const Scene& scene, const std::string& vessel, double t) {
  return InputError(scene.file.string(), 0,
                    "vessel '" + vessel + "' is aground at " + std::to_string(t) +
                        " s: a part of it is outside the sea's outline");
}

void requireClearOfGround(const Scene& scene, const std::string& vessel, double t, double draft,
                          const TerrainMap& terrain, std::span<const glm::dvec2> places,
                          std::span<const SurfaceSample> water) {
  double sum = 0.0;
  std::size_t wet = 0;
  double highest = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < places.size(); ++i) {
    highest = std::max(highest, terrain.heightAt(places[i]));
    if (!std::isfinite(water[i].height)) continue;
    sum += water[i].height;
    ++wet;
  }
  const double level = wet > 0 ? sum / static_cast<double>(wet) : 0.0;
  if (!(highest >= level - draft)) return;
  throw InputError(scene.file.string(), 0,
                   "vessel '" + vessel + "' is aground at " + std::to_string(t) +
                       " s: the terrain under it stands " + std::to_string(std::abs(highest)) +
                       " m " + (highest < 0.0 ? "below" : "above") +
                       " the still water, its keel is " + std::to_string(draft) +
                       " m below the water");
}

void requireFreeToMove(const Scene& scene, const std::string& name, const FreeVessel& vessel) {
  if (has(vessel.status(), SampleStatus::dry)) throw aground(scene, name, vessel.time());
  if (!has(vessel.status(), SampleStatus::belowBed)) return;
  if (scene.terrain.map) {
    throw InputError(scene.file.string(), 0,
                     "vessel '" + name + "' is aground at " + std::to_string(vessel.time()) +
                         " s: a part of its hull is below the terrain, or a trough has laid the "
                         "bed dry");
  }
  throw InputError(scene.file.string(), 0,
                   "vessel '" + name + "' touches the bed at " + std::to_string(vessel.time()) +
                       " s: its keel or a trough is " + std::to_string(scene.sea.depth) +
                       " m below the still-water level");
}

}  // namespace seaway::bridge
