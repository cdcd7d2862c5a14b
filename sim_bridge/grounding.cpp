#include "sim_bridge/grounding.h"

namespace seaway::bridge {

InputError aground(const Scene& scene, const std::string& vessel, double t) {
  return InputError(scene.file.string(), 0,
                    "vessel '" + vessel + "' is aground at " + std::to_string(t) +
                        " s: a part of it is outside the sea's outline");
}

void requireFreeToMove(const Scene& scene, const std::string& name, const FreeVessel& vessel) {
  if (has(vessel.status(), SampleStatus::dry)) throw aground(scene, name, vessel.time());
  if (!has(vessel.status(), SampleStatus::belowBed)) return;
  throw InputError(scene.file.string(), 0,
                   "vessel '" + name + "' touches the bed at " + std::to_string(vessel.time()) +
                       " s: its keel or a trough is " + std::to_string(scene.sea.depth) +
                       " m below the still-water level");
}

}  // namespace seaway::bridge
