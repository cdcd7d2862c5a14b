#pragma once

#include <iosfwd>
#include <limits>
#include <optional>
#include <string>

#include "sim_bridge/commands/command.h"

namespace seaway::bridge {

struct FitOptions {
  std::string spectrum;       ///< as `spectrumFrom` takes it
  std::string format;         ///< of a file; empty: by its content
  std::optional<int> record;  ///< of a file, from 0
  std::string time;           ///< of a file, ISO 8601
  std::string model = "perlin";
  std::optional<int> octaves;
  std::optional<double>
      from_deg;  ///< compass direction the waves come from; else 0, with a warning
  double depth = std::numeric_limits<double>::infinity();  ///< m
  std::string out;                                         ///< sea state file
  bool json = false;
};

/// `seaway fit`: octaves for a spectrum, as a sea state file. Status 2, and nothing written, where
/// the spectrum cannot be read or holds no energy; 1 where the solver finds nothing usable.
int runFit(const FitOptions& options, std::ostream& out);
void addFitCommand(CLI::App& app, ChosenCommand& chosen);

}  // namespace seaway::bridge
