#pragma once

#include <filesystem>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>

#include "sim_bridge/scene/schema.h"
#include "sim_bridge/scene/vessel_hull.h"
#include "sim_bridge/vessel/box_hull.h"

namespace seaway::bridge {

/// How a vessel is drawn.
enum class VesselShape {
  launch,
  openLaunch,
  buoy,
  mesh,  ///< VesselDrawing::source
};

struct VesselDrawing {
  VesselShape shape = VesselShape::launch;
  std::string source;  ///< of shape `mesh`: see hullByName; empty: the mesh that loads are taken on
  glm::vec3 hullColour{0.05f, 0.10f, 0.22f};  ///< linear reflectance, each in [0, 1]
  glm::vec3 deckColour{0.55f, 0.53f, 0.48f};
  glm::vec3 houseColour{0.80f, 0.80f, 0.78f};
};

/// The hull that makes a vessel's waves.
enum class WakeForm { drawn, box, wigley };

struct VesselWake {
  WakeForm form = WakeForm::drawn;
  double strength = 1.0;      ///< part of the waves that linear theory gives such a hull
  bool feltByItself = false;  ///< else its hull does not ride its own waves
};

/// Which navigation lights a vessel shows from sunset to sunrise.
enum class LightsShown { automatic, underWay, atAnchor, none };

/// Places in the body frame, m; at the origin: by the hull's size.
struct VesselLights {
  LightsShown shown = LightsShown::automatic;
  glm::dvec3 masthead{0.0}, sidelight{0.0}, stern{0.0};  ///< sidelight: the port one
};

/// A vessel file (`configs/vessels/*.yaml`).
struct VesselModel {
  std::string description;
  BoxHull hull;
  VesselDrawing drawing;
  VesselHullMesh mesh;
  Propeller propeller;  ///< diameter 0: none
  Rudder rudder;        ///< area 0: none
  VesselWake wake;
  VesselLights lights;
};

/// Keys of a vessel file.
const Mapping<VesselModel>& vesselModelSchema();

/// Reads a vessel file. Throws InputError for anything its schema does not allow, and for a hull
/// that would sink or capsize at rest.
VesselModel loadVesselModel(const std::filesystem::path& file);

}  // namespace seaway::bridge
