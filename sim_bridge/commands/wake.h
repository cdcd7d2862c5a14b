#pragma once

#include <iosfwd>
#include <limits>
#include <string>

#include "sim_bridge/commands/command.h"

namespace seaway::bridge {

struct WakeOptions {
  double speed = 5.0;                                      ///< m/s, (0, 60]
  double length = 12.0;                                    ///< of the hull, m, [0.5, 500]
  double depth = std::numeric_limits<double>::infinity();  ///< m, > 0
  std::string out;                                         ///< folder; made if need be
  bool json = false;
};

/// `seaway wake`: the steady wake of a Wigley hull in still water, as `wake.png` and `wake.json` in
/// `out`, with wavelength and angles beside theory: the cusp's, beyond the critical speed the
/// front's. What does not exist (transverse waves beyond that speed, angles about it, where the
/// wedge is wider than 60 degrees) is "none", in JSON null. Throws InputError for options out of
/// range, and for a hull so slow that its waves are lost beside it (U < 0.15 √(gL)).
int runWake(const WakeOptions& options, std::ostream& out);
void addWakeCommand(CLI::App& app, ChosenCommand& chosen);

}  // namespace seaway::bridge
