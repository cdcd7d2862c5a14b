#pragma once

#include <iosfwd>
#include <string>

#include "sim_bridge/commands/command.h"
#include "sim_bridge/scene/scene.h"

namespace seaway::bridge {

struct TuneOptions {
  std::string scene, out;
  Performance wanted;  ///< in place of the scene's own
  std::string backend = "osmesa";
  bool json = false;
};

/// Finds settings for what a scene asks of accuracy and cost, and writes the scene with them.
int runTune(const TuneOptions& options, std::ostream& out);

void addTuneCommand(CLI::App& app, ChosenCommand& chosen);

}  // namespace seaway::bridge
