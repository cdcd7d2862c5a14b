#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "sim_bridge/dynamics/propulsion.h"
#include "sim_bridge/scene/schema.h"
#include "sim_bridge/vessel/box_hull.h"
#include "surface/hull/hull_model.h"

namespace seaway::bridge {

/// The mesh that a vessel's loads are taken on where it moves freely, as a vessel file gives it.
/// Mass, height of the centre of gravity, gyradii, damping and columns are those of `hull`.
struct VesselHullMesh {
  std::string source;            ///< see hullByName; empty: the box of `hull`
  std::filesystem::path folder;  ///< of the vessel file, which `source` is relative to
  int triangles = 800;           ///< of shapes
  double metresPerUnit = 1.0;
  std::string forward = "+x", up = "+z";
  glm::dvec3 origin{0.0};  ///< of the body, in the file's frame turned and in m
  LoadLevel level = LoadLevel::meshDynamic;
  std::optional<double> knownVolume;      ///< m³, below the body's z = 0
  std::optional<double> knownWaterplane;  ///< m², there
  double formDrag = 0.5;
  std::optional<double> skinFriction;
  double slamming = 0.0, windDrag = 0.5;
  glm::dvec3 addedMass{0.05, 0.8, 1.0};    ///< surge, sway, heave, parts of the mass
  glm::dvec3 addedInertia{0.2, 0.8, 0.5};  ///< roll, pitch, yaw, parts of the moments of inertia
};

/// The mesh that `source` names, in the body frame. Throws InputError for one that cannot be read.
TriangleMesh hullMeshOf(const VesselHullMesh& mesh);

/// The hull ready for loads. The centre of gravity lies above the centre of buoyancy, as high above
/// the lowest point as `box` says. Throws InputError for a mesh that cannot float so.
std::shared_ptr<const HullModel> hullModelOf(const VesselHullMesh& mesh, const BoxHull& box);

Mapping<VesselHullMesh> hullMeshSchema();
Mapping<Propeller> propellerSchema();
Mapping<Rudder> rudderSchema();

}  // namespace seaway::bridge
