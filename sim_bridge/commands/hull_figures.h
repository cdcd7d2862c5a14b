#pragma once

#include <filesystem>
#include <iosfwd>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "surface/hull/hydrostatics.h"
#include "surface/hull/mesh_check.h"

namespace seaway::bridge {

/// What `seaway hull` found of a hull at rest.
struct HullFigures {
  std::string name;
  MeshReport check;
  MeshBounds bounds;
  MassProperties whole;         ///< of the space inside
  FloatingBody body;            ///< its mesh must outlive this
  bool gravityAssumed = false;  ///< no centre of gravity was given
  double volumeFactor = 1.0;    ///< of a calibration
  Equilibrium rest;
  double draft = 0.0;                 ///< amidships, above the lowest point, m
  std::vector<RightingLever> levers;  ///< 0 to 180 degrees
};

/// Keys in SI and the body frame of the mesh; see the README.
nlohmann::ordered_json asJson(const HullFigures& figures);
/// The same for a mesh that cannot float: figures null, `faults` listed.
nlohmann::ordered_json faultsAsJson(const std::string& name, const MeshReport& check);

void writeText(const HullFigures& figures, std::ostream& out);

/// Writes hull.json and a self-contained report.html with the curve of levers and the hydrostatic
/// curves over the draft.
void writeHullReport(const HullFigures& figures, const std::filesystem::path& folder);

}  // namespace seaway::bridge
