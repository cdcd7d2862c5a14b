#pragma once

#include <iosfwd>
#include <string>

#include "sim_bridge/commands/command.h"

namespace seaway::bridge {

struct ExplainOptions {
  std::string scene;
  double time = 0.0;  ///< s
  std::string backend = "osmesa";  ///< osmesa, egl or egl:N
  bool json = false;
};

/// `seaway explain`: which effects of a scene run at a time, why, and what they cost: of one step
/// and one frame of each camera.
int runExplain(const ExplainOptions& options, std::ostream& out);
void addExplainCommand(CLI::App& app, ChosenCommand& chosen);

}  // namespace seaway::bridge
