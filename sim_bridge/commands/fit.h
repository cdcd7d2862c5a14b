#pragma once

#include <cstdint>
#include <iosfwd>
#include <limits>
#include <optional>
#include <string>

#include "sim_bridge/commands/command.h"

namespace seaway::bridge {

struct FitOptions {
  std::string spectrum;       ///< file, or a family such as `jonswap:Hs,Tp,gamma`
  std::optional<int> record;  ///< of a file, from 0
  std::string time;           ///< of a file, ISO 8601
  std::string format;         ///< of a file; empty: by its content
  std::string model = "perlin";
  std::optional<int> octaves;
  int starts = 4;                  ///< of group fits: one may stop in a poor minimum
  std::int64_t seed = 1;           ///< of starts after the first, and of the verifying buoy's sea
  bool parameters = false;         ///< fit H_m0, T_p, γ, direction, s of one or two systems too
  double degreesOfFreedom = 20.0;  ///< of each spectral estimate
  std::optional<double>
      from_deg;  ///< compass direction the waves come from: overrides a spectrum's own
  double depth = std::numeric_limits<double>::infinity();  ///< m
  std::string out;                                         ///< sea state file; empty: none
  std::string report;   ///< folder for sea.yaml and report.html; empty: none
  bool verify = false;  ///< moor a buoy in the fitted field
  double hours = 3.0;   ///< of its record
  bool json = false;
};

/// `seaway fit`: octaves for a spectrum, as a sea state file and a report. Status 2, and nothing
/// written, where the spectrum cannot be read or holds no energy; 1 where the solver finds nothing
/// usable.
int runFit(const FitOptions& options, std::ostream& out);
void addFitCommand(CLI::App& app, ChosenCommand& chosen);

}  // namespace seaway::bridge
