#pragma once

#include <iosfwd>
#include <optional>
#include <string>

#include "sim_bridge/commands/command.h"

namespace seaway::bridge {

struct SoakOptions {
  std::string scene;
  std::string out;              ///< folder; empty: out/ and the scene's name
  std::optional<double> hours;  ///< simulated; none: the scene's duration
  double every = 3600.0;        ///< simulated s between readings
  double settled = 10800.0;     ///< s after which memory is to stay as it is
  std::string backend = "osmesa";
  bool json = false;
};

/// Sails a scene for long and tells what memory and steps do. 1 where memory strays by more than
/// 2 % once it has settled, or where the run cannot be resumed bit for bit.
int runSoak(const SoakOptions& options, std::ostream& out);

void addSoakCommand(CLI::App& app, ChosenCommand& chosen);

}  // namespace seaway::bridge
