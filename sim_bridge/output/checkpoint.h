#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim_bridge/output/kept_text.h"
#include "sim_bridge/scene/scene.h"

namespace seaway::bridge {

/// A run in the middle, to be gone on with later by the same build on the same machine.
struct Checkpoint {
  double time = 0.0;  ///< s since the scene's epoch
  std::string state;  ///< of the simulation (Simulation::state)
  /// What of each file of telemetry goes with it (Telemetry::keep); none: it is not kept.
  std::vector<KeptText> telemetry{};
};

/// Writes it with what the scene is made of: its file, and those of vessels and sea state that it
/// names. Appears whole or not at all. Throws std::runtime_error where it cannot be written.
void writeCheckpoint(const std::filesystem::path& file, const Scene& scene,
                     const Checkpoint& checkpoint);

/// Throws InputError, naming the file, for one that is missing, damaged, cut off, of another format
/// or of a scene that has changed since: its own file, another that it names, seed or step.
Checkpoint readCheckpoint(const std::filesystem::path& file, const Scene& scene);

}  // namespace seaway::bridge
