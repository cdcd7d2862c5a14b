#pragma once

#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>

#include "sim_bridge/commands/command.h"

namespace seaway::bridge {

struct SelftestOptions {
  std::string configs;       ///< folder with hard_cases.yaml and scenes/; empty: found
  std::string out;           ///< folder for scenes that fail; empty: none are kept
  std::string only;          ///< regular expression of names; empty: all
  std::int64_t count = 100;  ///< random cases
  double hours = 0.0;        ///< go on with random cases for so long instead
  double seconds = 0.0;      ///< begin no more random cases after so long; 0: no limit
  double limit = 60.0;       ///< s a case may take
  std::int64_t seed = 1;     ///< of the first random case; the next ones follow
  bool list = false;         ///< print the catalogue, run nothing
  bool json = false;
};

/// Tries the catalogue of hard cases, then random scenes. 1 where any case fails.
int runSelftest(const SelftestOptions& options, std::ostream& out);

void addSelftestCommand(CLI::App& app, ChosenCommand& chosen);

}  // namespace seaway::bridge
