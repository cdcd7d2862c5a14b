#pragma once

#include <iosfwd>
#include <string>

#include "sim_bridge/commands/command.h"

namespace seaway::bridge {

struct ExplainOptions {
  std::string scene;
  double time = 0.0;               ///< s
  std::string camera;              ///< name; empty: all of the scene's
  std::string backend = "osmesa";  ///< osmesa, egl or egl:N
  bool json = false;
};

/// `seaway explain`: which effects of a scene run at a time, why, and what they cost: wall time of
/// one step (waves under vessels, motion) or of one frame (the rest; mean of the cameras, one frame
/// of the scene's size each, or the one camera asked for). Set-up on first use is not in it: a step
/// and a frame of each camera are done before. The sun has no pass of its own: the water's shading,
/// or the sky's, does its work. JSON: effects with name, state, reason, memory_bytes, cost_us,
/// cost_per (step or frame), and cost_inside where another effect's cost holds it.
int runExplain(const ExplainOptions& options, std::ostream& out);
void addExplainCommand(CLI::App& app, ChosenCommand& chosen);

}  // namespace seaway::bridge
