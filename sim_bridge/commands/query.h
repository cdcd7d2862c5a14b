#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "sim_bridge/commands/command.h"

namespace seaway::bridge {

struct QueryOptions {
  std::string scene;
  std::optional<double> time;   ///< s; may be left out where every point has its t_s
  std::string points;           ///< CSV file, or "-" for standard input
  std::vector<std::string> at;  ///< LATITUDE,LONGITUDE
  double tolerance = 0.0;       ///< m
  bool ellipsoidal = false;
  bool json = false;
};

/// `seaway query`: the sea at points, as CSV or JSON.
///
/// Columns out: those that came in, then height_m (above the still-water level), slope_x, slope_y
/// (along the sea plane's axes, east and north at the anchor), velocity_z_m_s (∂η/∂t), error_m,
/// bound_m, status, and with `ellipsoidal` ellipsoidal_height_m. Points beyond the geodesy's range
/// or not finite get NaN and say so in their status; numbers read back to the same bits.
int runQuery(const QueryOptions& options, std::istream& in, std::ostream& out);
void addQueryCommand(CLI::App& app, ChosenCommand& chosen);

}  // namespace seaway::bridge
