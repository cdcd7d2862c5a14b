#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "sim_bridge/commands/command.h"
#include "surface/hull/hull_file.h"

namespace seaway::bridge {

struct HullOptions {
  std::string mesh;  ///< see hullByName
  HullFileSettings file;
  std::size_t triangles = 800;               ///< of shapes
  std::optional<double> draft;               ///< upright, above the lowest point, m
  std::optional<double> mass;                ///< kg; at most one of the two
  std::optional<double> heel_deg;            ///< held; positive starboard down
  std::vector<double> gravity;               ///< centre of gravity, body frame, m; empty: above B
  double density = 1026.0;                   ///< of the water, kg/m³
  std::optional<double> knownVolume;         ///< displacement at that draft, m³: calibration
  std::optional<double> knownWaterplane;     ///< its area there, m²; needs knownVolume
  std::vector<double> distanceAt;            ///< points x y z, body frame, m
  std::string repair;                        ///< file to write a watertight mesh to
  double voxelSize = 0.0, widestHole = 0.0;  ///< m; see RepairSettings
  std::string report;                        ///< folder for report.html and hull.json
  bool json = false;
};

/// `seaway hull`: checks a mesh and tells its hydrostatics at a draft, or at rest under a mass.
/// Throws InputError for a mesh that cannot float as it is (after the JSON that says so), and for
/// options out of range.
int runHull(const HullOptions& options, std::ostream& out);
void addHullCommand(CLI::App& app, ChosenCommand& chosen);

}  // namespace seaway::bridge
