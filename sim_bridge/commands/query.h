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
  double cutoff = 0.0;          ///< shortest waves wanted, m
  std::string model;            ///< group or perlin in place of the scene's; empty: the scene's
  bool orbital = false;
  bool ellipsoidal = false;
  bool json = false;
};

/// `seaway query`: the sea at points, as CSV or JSON.
///
/// Columns out: those that came in, then height_m (above the still-water level), slope_x, slope_y
/// (along the sea plane's axes, east and north at the anchor), velocity_z_m_s (∂η/∂t), error_m,
/// bound_m, status; with `orbital` orbital_u_m_s, orbital_v_m_s, orbital_w_m_s (the water at the
/// surface, along the sea plane's axes and up, the current not included; NaN for Perlin octaves);
/// with `ellipsoidal` ellipsoidal_height_m. Points beyond the geodesy's range
/// or not finite get NaN and say so in their status; numbers read back to the same bits.
int runQuery(const QueryOptions& options, std::istream& in, std::ostream& out);
void addQueryCommand(CLI::App& app, ChosenCommand& chosen);

}  // namespace seaway::bridge
