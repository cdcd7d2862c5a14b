#pragma once

#include <iosfwd>
#include <string>

#include "sim_bridge/commands/command.h"

namespace seaway::bridge {

struct LayerOptions {
  std::string input;  ///< a scene, or an OpenVDB file to describe
  double time = 0.0;  ///< s since the scene's epoch, ≥ 0
  std::string out;    ///< OpenVDB file to write; wanted with a scene, not with a file
  bool json = false;
};

/// `seaway layer`: what lies on a scene's water at a time as an OpenVDB file of ordinary grids, or
/// the grids of such a file. Throws InputError for a file that cannot be read or written.
int runLayer(const LayerOptions& options, std::ostream& out);
void addLayerCommand(CLI::App& app, ChosenCommand& chosen);

}  // namespace seaway::bridge
