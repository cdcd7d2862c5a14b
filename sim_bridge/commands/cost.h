#pragma once

#include <iosfwd>
#include <string>

#include "sim_bridge/commands/command.h"

namespace seaway::bridge {

struct CostOptions {
  std::string scene;
  std::string out;  ///< folder
  bool quick = false;
  std::string backend = "osmesa";  ///< osmesa, egl or egl:N
  bool json = false;
};

/// Measures what accuracy costs on this machine: `report.html`, `cost.json` and `cost.csv` in the
/// folder, and a table (or the JSON) on `out`.
int runCost(const CostOptions& options, std::ostream& out);
void addCostCommand(CLI::App& app, ChosenCommand& chosen);

}  // namespace seaway::bridge
