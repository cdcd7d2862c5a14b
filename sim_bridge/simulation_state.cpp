#include <sstream>

#include "sim_bridge/simulation.h"
#include "surface/state_archive.h"

// What of a simulation is written down: all that its settings and the time do not give.
namespace seaway::bridge {

template <class Archive>
void Simulation::archive(Archive& archive) {
  std::uint64_t count = vessels_.size();
  archivePlain(archive, count);
  if (count != vessels_.size()) {
    throw InputError("a checkpoint is of a scene with other vessels");
  }
  archivePlain(archive, steps_);
  archivePlain(archive, time_);
  for (Vessel& vessel : vessels_) {
    int kind = vessel.prescribed() ? 0 : vessel.free() ? 1 : 2;
    archivePlain(archive, kind);
    if (PrescribedVessel* prescribed = vessel.prescribed(); prescribed && kind == 0) {
      prescribed->archive(archive);
    } else if (FreeVessel* free = vessel.free(); free && kind == 1) {
      free->archive(archive);
    } else {
      throw InputError("a checkpoint is of vessels that move otherwise, or that a host sails");
    }
  }
  wakes_.archive(archive);
  detail_.archive(archive, time_);
}

std::string Simulation::state() const {
  std::ostringstream stream;
  StateWriter writer(stream);
  Simulation copy = *this;
  copy.archive(writer);
  return std::move(stream).str();
}

Simulation Simulation::resumed(const Scene& scene, const Sea& sea, Audience audience,
                               const std::string& state) {
  Simulation simulation(scene, sea);
  std::istringstream stream(state);
  StateReader reader(stream);
  try {
    simulation.wakes_.setAudience(std::move(audience));
    simulation.archive(reader);
  } catch (const cereal::Exception&) {
    throw InputError("a checkpoint is cut off");
  }
  if (stream.peek() != std::istringstream::traits_type::eof()) {
    throw InputError("a checkpoint is of another scene: it says more than this one can take");
  }
  simulation.showDetail();
  return simulation;
}

}  // namespace seaway::bridge
