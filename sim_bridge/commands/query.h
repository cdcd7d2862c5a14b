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
  bool pressure = false;
  std::optional<double> height;  ///< of all points, m above the still-water level
  bool ellipsoidal = false;
  bool json = false;
};

/// `seaway query`: the sea at points, as CSV or JSON.
///
/// Columns out: those that came in, then height_m (above the still-water level), slope_x, slope_y
/// (along the sea plane's axes, east and north at the anchor), velocity_z_m_s (∂η/∂t), error_m,
/// bound_m, status;
/// with `orbital` orbital_u_m_s, orbital_v_m_s, orbital_w_m_s (velocity of the water along the sea
/// plane's axes and up, the current not included); with `pressure` pressure_pa (gauge pressure,
/// hydrostatic plus dynamic); with `ellipsoidal` ellipsoidal_height_m.
///
/// Velocity and pressure are those at `height` or the column z_m (sampleKinematics), else at the
/// surface, where the pressure is 0. Where they are not defined they are NaN and the status says
/// why: above_surface, below_bed, no_kinematics (Perlin octaves).
///
/// Times may lie before the scene's epoch: the sea is a function of any time. Points beyond the
/// geodesy's range or not finite get NaN and say so in their status; numbers read back to the same
/// bits. JSON has `points`, and in `sea.blocked_octaves` the octaves that the current stops.
int runQuery(const QueryOptions& options, std::istream& in, std::ostream& out);
void addQueryCommand(CLI::App& app, ChosenCommand& chosen);

}  // namespace seaway::bridge
