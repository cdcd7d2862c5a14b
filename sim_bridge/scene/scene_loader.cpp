#include "sim_bridge/scene/scene_loader.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "sim_bridge/scene/outline_file.h"
#include "sim_bridge/scene/terrain_file.h"
#include "sim_bridge/scene/vessel_launch.h"
#include "sim_bridge/scene_detail.h"
#include "surface/geodesy.h"
#include "surface/input_error.h"

namespace seaway::bridge {
namespace {

namespace fs = std::filesystem;

const YamlValue& childOf(const YamlValue& value, const char* name) {
  const YamlValue* child = value.find(name);
  return child ? *child : value;
}

// The file a key names; a fault there tells both files.
fs::path referredFile(const YamlValue& key, const fs::path& sceneFile) {
  const fs::path file = fs::path(key.scalar).is_absolute() ? fs::path(key.scalar)
                                                           : sceneFile.parent_path() / key.scalar;
  std::error_code ignored;
  if (!fs::is_regular_file(file, ignored)) {
    key.fail("no such file: " + file.lexically_normal().string());
  }
  return file;
}

template <class T>
void requireUniqueNames(const YamlValue* list, const std::vector<T>& items) {
  std::set<std::string> names;
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (names.insert(items[i].name).second) continue;
    childOf(list->values[i], "name").fail("'" + items[i].name + "' is given twice");
  }
}

void requireInGeodesicRange(const YamlValue& value, const Geodesy& geodesy, double latitude_deg,
                            double longitude_deg) {
  if (geodesy.seaPlaneFromGeodetic(latitude_deg, longitude_deg).inRange) return;
  value.fail("is farther than " + numberText(Geodesy::usableRange() / 1000.0) +
             " km from the scene's anchor");
}

// A fit has its target's wave height to the last digits; half a percent leaves room for rounding
// by hand.
void warnOfEditedOctaves(const FileState& state, const YamlValue& key) {
  const double target = state.seaState.provenance.hm0Target;
  const double given = state.seaState.significantWaveHeight();
  if (target == 0.0 || std::abs(given - target) <= 0.005 * target) return;
  spdlog::warn(
      "{}:{}: key '{}': the octaves of {} have H_m0 {:.4g} m, its hm0_target_m says {:.4g}",
      key.file->string(), key.line, key.key, state.path, given, target);
}

void resolveSeaState(Scene& scene, const YamlValue& document) {
  const YamlValue& state = *document.find("sea")->find("state");
  scene.sea.stateLine = state.line;
  if (auto* file = std::get_if<FileState>(&scene.sea.state)) {
    file->seaState = loadSeaState(referredFile(*state.find("file"), scene.file));
    warnOfEditedOctaves(*file, *state.find("file"));
  }
  const auto* octaves = std::get_if<FittedSeaState>(&scene.sea.state);
  if (octaves && octaves->octaves.empty()) {
    state.fail("has no octaves (for flat water use `calm: {}`)");
  }
}

/// What free motion and drawings need of a vessel's mesh, checked here so that a fault in it names
/// the scene's line.
void resolveMesh(SceneVessel& vessel, const YamlValue& value) {
  const bool free = vessel.motion == VesselMotion::free;
  const YamlValue* turn = value.find("turn_deg_s");
  if (free && turn) {
    turn->fail("is for prescribed motion only: a free vessel is steered along waypoints");
  }
  const char* unsteered = free ? whyUnsteered(vessel) : nullptr;
  if (unsteered) value.find("waypoints")->fail(unsteered);
  if (!free && vessel.model.drawing.shape != VesselShape::mesh) return;
  try {
    vessel.mesh = hullModelOf(vessel.model.mesh, vessel.model.hull);
  } catch (const InputError& fault) {
    childOf(value, "model").fail(fault.what());
  }
}

void resolveVessels(Scene& scene, const YamlValue& document, const Geodesy& geodesy) {
  const YamlValue* list = document.find("vessels");
  requireUniqueNames(list, scene.vessels);
  for (std::size_t i = 0; i < scene.vessels.size(); ++i) {
    SceneVessel& vessel = scene.vessels[i];
    const YamlValue& value = list->values[i];
    requireInGeodesicRange(childOf(value, "start"), geodesy, vessel.start.latitude_deg,
                           vessel.start.longitude_deg);
    for (std::size_t k = 0; k < vessel.waypoints.size(); ++k) {
      const Place& waypoint = vessel.waypoints[k];
      requireInGeodesicRange(value.find("waypoints")->values[k], geodesy, waypoint.latitude_deg,
                             waypoint.longitude_deg);
    }
    vessel.model = loadVesselModel(referredFile(*value.find("model"), scene.file));
    resolveMesh(vessel, value);
  }
}

void resolveScenery(Scene& scene, const YamlValue& document, const Geodesy& geodesy) {
  const YamlValue* list = document.find("scenery");
  requireUniqueNames(list, scene.scenery);
  SceneryMeshes meshes;
  for (std::size_t i = 0; i < scene.scenery.size(); ++i) {
    SceneryObject& object = scene.scenery[i];
    const YamlValue& value = list->values[i];
    requireInGeodesicRange(childOf(value, "place"), geodesy, object.place.latitude_deg,
                           object.place.longitude_deg);
    const YamlValue& key = *value.find("mesh");
    const fs::path file = referredFile(key, scene.file);
    try {
      object.mesh = meshes.read(file, object.axes);
    } catch (const InputError& fault) {
      key.fail(fault.what());
    }
  }
}

void resolveOutline(Scene& scene, const YamlValue& document, const Geodesy& geodesy) {
  const YamlValue* key = document.find("sea")->find("outline");
  if (!key) return;
  scene.sea.outline =
      std::make_shared<const WaterOutline>(loadOutline(referredFile(*key, scene.file), geodesy));
}

/// What a terrain's file needs told and what it must not be told.
void requireSoundTerrain(const SceneTerrain& terrain, const YamlValue& value, bool isPicture) {
  for (const char* key : {"extent", "centre", "size_m", "height_m"}) {
    const YamlValue* given = value.find(key);
    if (given && !isPicture) given->fail("is for a PNG only: a GeoTIFF tells it itself");
  }
  if (!isPicture) return;
  if (terrain.extent.has_value() == terrain.centre.has_value()) {
    value.fail("a PNG needs exactly one of extent and centre");
  }
  if (terrain.centre && !(terrain.size.x > 0.0 && terrain.size.y > 0.0)) {
    childOf(value, "size_m").fail("a PNG about a centre needs its size, above 0 m each way");
  }
  if (!value.find("height_m")) value.fail("a PNG needs height_m: its heights at black and white");
  if (value.find("no_data_m")) value.find("no_data_m")->fail("is for a GeoTIFF only");
  if (!terrain.extent) return;
  const TerrainExtent& extent = *terrain.extent;
  if (!(extent.south_deg < extent.north_deg)) {
    value.find("extent")->fail("is upside down: south_deg must be below north_deg");
  }
  const double width = extent.east_deg - extent.west_deg;
  if (width == 0.0 || std::abs(width) >= 360.0) {
    value.find("extent")->fail("has no width: east_deg must lie east of west_deg");
  }
  if (width < 0.0 && !(extent.west_deg > 0.0 && extent.east_deg < 0.0)) {
    value.find("extent")->fail(
        "is inverted: east_deg is below west_deg, which is for maps across 180° alone");
  }
}

void resolveTerrain(Scene& scene, const YamlValue& document, const Geodesy& geodesy) {
  const YamlValue* value = document.find("terrain");
  if (!value) return;
  const fs::path file = referredFile(*value->find("file"), scene.file);
  requireSoundTerrain(scene.terrain, *value, isPngFile(file));
  const double level = scene.terrain.datum == TerrainDatum::geoid ? scene.sea.waterLevel : 0.0;
  scene.terrain.map =
      std::make_shared<const TerrainMap>(loadTerrain(scene.terrain, file, geodesy, level));
}

std::vector<std::string> vesselNames(const Scene& scene) {
  std::vector<std::string> names;
  for (const SceneVessel& vessel : scene.vessels) names.push_back(vessel.name);
  return names;
}

void requireMount(const Scene& scene, const SceneCamera& camera, const YamlValue& value) {
  const std::vector<std::string> names = vesselNames(scene);
  if (std::find(names.begin(), names.end(), camera.mount) != names.end()) return;
  const std::string nearest = nearestName(camera.mount, names);
  value.find("mount")->fail("no vessel is called '" + camera.mount + "'" +
                            (nearest.empty() ? "" : "; did you mean '" + nearest + "'?"));
}

void checkCameras(const Scene& scene, const YamlValue& document, const Geodesy& geodesy) {
  const YamlValue* list = document.find("cameras");
  requireUniqueNames(list, scene.cameras);
  for (std::size_t i = 0; i < scene.cameras.size(); ++i) {
    const SceneCamera& camera = scene.cameras[i];
    const YamlValue& value = list->values[i];
    if (camera.mount.empty() == !camera.place.has_value()) {
      value.fail("needs exactly one of mount and place");
    }
    if (camera.place) {
      for (const char* key : {"position_m", "stabilised"}) {
        if (const YamlValue* given = value.find(key)) given->fail("is for mounted cameras only");
      }
      requireInGeodesicRange(*value.find("place"), geodesy, camera.place->latitude_deg,
                             camera.place->longitude_deg);
    } else {
      requireMount(scene, camera, value);
    }
  }
}

void checkEvents(const Scene& scene, const YamlValue& document, const Geodesy& geodesy) {
  const auto requireNear = [&](const char* list, std::size_t i, const Place& place) {
    const YamlValue& value = document.find(list)->values[i];
    requireInGeodesicRange(childOf(value, "place"), geodesy, place.latitude_deg,
                           place.longitude_deg);
  };
  for (std::size_t i = 0; i < scene.splashes.size(); ++i) {
    requireNear("splashes", i, scene.splashes[i].place);
  }
  const auto limit = [&](const char* list, std::size_t count, std::size_t most) {
    if (count <= most) return;
    document.find(list)->fail("has " + std::to_string(count) + " entries; " + std::to_string(most) +
                              " at the most");
  };
  limit("splashes", scene.splashes.size(), SurfaceEvents::mostSplashes);
  limit("ripples", scene.ripples.size(), 16);
  for (std::size_t i = 0; i < scene.ripples.size(); ++i) {
    requireNear("ripples", i, scene.ripples[i].place);
    try {
      RipplePool pool(rippleSource(scene.ripples[i], geodesy));
    } catch (const InputError& fault) {
      document.find("ripples")->values[i].fail(fault.what());
    }
  }
}

void resolveLayers(Scene& scene, const YamlValue& document, const Geodesy& geodesy) {
  for (std::size_t i = 0; i < scene.layers.size(); ++i) {
    SceneLayer& layer = scene.layers[i];
    const YamlValue& value = document.find("layers")->values[i];
    layer.line = value.line;
    if (layer.place) {
      requireInGeodesicRange(childOf(value, "place"), geodesy, layer.place->latitude_deg,
                             layer.place->longitude_deg);
    } else {
      layer.file = referredFile(*value.find("file"), scene.file);
    }
  }
}

Scene sceneOf(const YamlValue& document, const fs::path& file) {
  if (document.kind == YamlValue::Kind::null) throw InputError(file.string(), 0, "is empty");
  Scene scene;
  sceneSchema().read(scene, document);
  scene.file = file;
  const Geodesy geodesy({scene.sea.anchor.latitude_deg, scene.sea.anchor.longitude_deg, 0.0});
  resolveSeaState(scene, document);
  resolveOutline(scene, document, geodesy);
  resolveTerrain(scene, document, geodesy);
  resolveVessels(scene, document, geodesy);
  resolveScenery(scene, document, geodesy);
  checkCameras(scene, document, geodesy);
  checkEvents(scene, document, geodesy);
  resolveLayers(scene, document, geodesy);
  return scene;
}

}  // namespace

Scene loadScene(const fs::path& file) { return sceneOf(readYaml(file), file); }

Scene sceneFromText(const std::string& yaml, const fs::path& folder) {
  const fs::path file = folder / "<text>";
  return sceneOf(parseYaml(yaml, file), file);
}

}  // namespace seaway::bridge
