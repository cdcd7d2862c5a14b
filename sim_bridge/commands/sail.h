#pragma once

#include <iosfwd>
#include <optional>
#include <string>

#include "sim_bridge/commands/command.h"

namespace seaway::bridge {

struct SailOptions {
  std::string scene;
  std::string vessel;              ///< name; empty: the first
  std::optional<double> duration;  ///< s; else the scene's
  std::string out;                 ///< folder
  bool json = false;
};

/// `seaway sail`: one vessel of a scene under its own power, free in all six degrees on its mesh,
/// steered along its waypoints: `voyage.csv` and `voyage.json` in `out`. Throws InputError for
/// options out of range, a vessel without a propeller where it has waypoints, and a hull that
/// cannot float.
int runSail(const SailOptions& options, std::ostream& out);
void addSailCommand(CLI::App& app, ChosenCommand& chosen);

}  // namespace seaway::bridge
