#pragma once

#include <iosfwd>
#include <string>

#include "sim_bridge/commands/command.h"
#include "sim_bridge/scene/sea.h"
#include "surface/spectra/buoy_analysis.h"

namespace seaway::bridge {

struct BuoyOptions {
  std::string scene;
  std::string at;        ///< LATITUDE,LONGITUDE
  double hours = 3.0;    ///< h, (0, 100000]
  double rate = 2.0;     ///< samples a second, (0, 1000]
  double segment = 256;  ///< of Welch's method, s; at least 8 samples, at most the record
  std::string out;       ///< CSV of the record; empty: none
  bool json = false;
};

/// What a buoy moored at `place` (sea plane, m) writes down: `count` samples from the scene's epoch
/// on, every 1/`rate` s. Slopes are along the sea plane's axes.
BuoyRecord recordBuoy(const Sea& sea, glm::dvec2 place, double rate, std::size_t count);

/// `seaway buoy`: a heave–slope buoy moored in the scene's sea, and what its record says of it
/// (analyseBuoy), as a table or JSON. Directions are true compass degrees at the buoy, where waves
/// come from; what a flat sea leaves undefined is `nan`, in JSON null.
///
/// With `out`, the record as CSV: time_s,height_m,slope_x,slope_y (along the sea plane's axes, as
/// `seaway query` gives them). Throws InputError for options out of range.
int runBuoy(const BuoyOptions& options, std::ostream& out);
void addBuoyCommand(CLI::App& app, ChosenCommand& chosen);

}  // namespace seaway::bridge
