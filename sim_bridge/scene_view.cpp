#include "sim_bridge/scene_view.h"

#include <algorithm>
#include <optional>

#include "sim_bridge/output/progress.h"
#include "sim_bridge/scenery_objects.h"
#include "sim_bridge/vessel/navigation_lights.h"
#include "sim_bridge/vessel/vessel_mesh.h"
#include "surface/angles.h"
#include "surface/input_error.h"

namespace seaway::bridge {
namespace {

const VesselPose& mountOf(const Scene& scene, const std::string& name, const SceneMoment& moment) {
  for (const PlacedVessel& placed : moment.vessels) {
    if (scene.vessels[placed.vessel].name == name) return placed.pose;
  }
  throw InputError(scene.file.string(), 0, "the camera's mount '" + name + "' is not there");
}

void placeOnMount(render::Camera& camera, const SceneCamera& description, VesselPose mount) {
  if (description.stabilised) mount.height = mount.pitch = mount.roll = 0.0;
  const glm::dquat worldFromBody = mount.worldFromBody();
  camera.position = glm::dvec3(mount.position, mount.height) + worldFromBody * description.position;
  camera.worldFromCamera =
      worldFromBody * render::attitude(-radiansFromDegrees(description.yaw_deg),
                                       radiansFromDegrees(description.pitch_deg),
                                       radiansFromDegrees(description.roll_deg));
}

void placeFixed(render::Camera& camera, const SceneCamera& description, const Geodesy& geodesy) {
  const CameraPlace& place = *description.place;
  const SeaPlanePoint point = geodesy.seaPlaneFromGeodetic(place.latitude_deg, place.longitude_deg);
  camera.position = glm::dvec3(point.position, place.height);
  // At a pole the place's longitude, not its position, says which way north is.
  camera.worldFromCamera = render::attitude(
      towardFromCompassToward(description.yaw_deg) + point.convergence,
      radiansFromDegrees(description.pitch_deg), radiansFromDegrees(description.roll_deg));
}

}  // namespace

SceneView::SceneView(const Scene& scene) : scene_(&scene) {
  meshes_.reserve(scene.vessels.size());
  for (const SceneVessel& vessel : scene.vessels) meshes_.push_back(vesselMesh(vessel.model));
  scenery_.reserve(scene.scenery.size());
  for (const SceneryObject& object : scene.scenery) scenery_.push_back(sceneryMesh(object));
}

void SceneView::addScenery(const SceneMoment& moment) {
  for (std::size_t i = 0; i < scenery_.size(); ++i) {
    objects_.push_back(placedScenery(scene_->scenery[i], scenery_[i], *moment.geodesy,
                                     *moment.water, moment.time));
    objects_.back().instance = static_cast<std::uint16_t>(scene_->vessels.size() + i + 1);
    instances_.push_back({scene_->scenery[i].name, "scenery", nullptr});
  }
}

render::Camera placedCamera(const Scene& scene, const SceneCamera& camera,
                            const SceneMoment& moment, glm::ivec2 size) {
  render::Camera placed;
  placed.verticalFieldOfView = radiansFromDegrees(camera.fieldOfView_deg);
  placed.size = size;
  if (camera.intrinsics) {
    placed.intrinsics = scaled(camera.intrinsics->pixels, camera.intrinsics->size, size);
  }
  placed.distortion = camera.distortion;
  if (camera.place) {
    placeFixed(placed, camera, *moment.geodesy);
  } else {
    placeOnMount(placed, camera, mountOf(scene, camera.mount, moment));
  }
  return placed;
}

render::View SceneView::view(const Simulation& simulation, const SceneCamera& camera,
                             glm::ivec2 size, EffectLedger& ledger) {
  vessels_.clear();
  for (const Vessel& vessel : simulation.vessels()) {
    vessels_.push_back({vessels_.size(), vessel.pose()});
  }
  return view({simulation.time(), &simulation.surface(), &simulation.sea().geodesy, vessels_},
              camera, size, ledger);
}

render::View SceneView::view(const SceneMoment& moment, const SceneCamera& camera, glm::ivec2 size,
                             EffectLedger& ledger) {
  render::View view;
  view.water = moment.water;
  view.time = moment.time;
  view.camera = placedCamera(*scene_, camera, moment, size);
  const LightSettings& light = scene_->light;
  view.light.sunElevation = radiansFromDegrees(light.sun.elevation_deg);
  view.light.sunDirection = moment.geodesy->directionFromTrueHeading(
      glm::dvec2(view.camera.position), light.sun.azimuth_deg);
  view.light.windSpeed = light.wind.speed;
  view.light.turbidity = light.turbidity;
  view.light.visibility = light.visibility;
  view.light.terms = light.shading;
  view.light.toneCurve = light.toneCurve;
  view.light.dithers = light.dithers;
  if (light.moon) {
    view.light.moon = {radiansFromDegrees(light.moon->elevation_deg),
                       moment.geodesy->directionFromTrueHeading(glm::dvec2(view.camera.position),
                                                                light.moon->azimuth_deg),
                       light.moon->phase};
  }
  placeLamps(moment);
  view.lamps = lamps_;
  objects_.clear();
  instances_.clear();
  for (const PlacedVessel& placed : moment.vessels) {
    objects_.push_back(
        {&meshes_[placed.vessel], glm::dvec3(placed.pose.position, placed.pose.height),
         placed.pose.worldFromBody(), static_cast<std::uint16_t>(placed.vessel + 1)});
    instances_.push_back({scene_->vessels[placed.vessel].name, "vessel", nullptr});
  }
  addScenery(moment);
  for (std::size_t i = 0; i < instances_.size(); ++i) instances_[i].object = &objects_[i];
  view.objects = objects_;
  view.effects = &ledger;
  return view;
}

void SceneView::placeLamps(const SceneMoment& moment) {
  lamps_.clear();
  if (scene_->light.sun.elevation_deg >= 0.0 &&
      scene_->effects[static_cast<std::size_t>(Effect::lights)] != EffectSetting::on) {
    return;
  }
  for (const SceneLamp& lamp : scene_->lamps) {
    const SeaPlanePoint point =
        moment.geodesy->seaPlaneFromGeodetic(lamp.place.latitude_deg, lamp.place.longitude_deg);
    render::Lamp placed;
    placed.position = glm::dvec3(point.position, lamp.height);
    placed.colour = lamp.colour;
    placed.candela = lamp.candela;
    placed.shines = true;
    lamps_.push_back(placed);
  }
  for (const PlacedVessel& placed : moment.vessels) {
    const SceneVessel& vessel = scene_->vessels[placed.vessel];
    addNavigationLights(vessel.model, placed.pose, vessel.speed != 0.0, lamps_);
  }
}

Simulation replayWithProgress(const Scene& scene, const Sea& sea, double t) {
  std::optional<Progress> progress;
  return Simulation::replayed(scene, sea, t, [&](std::size_t done, std::size_t all) {
    if (!progress) progress.emplace("replay", all);
    progress->update(done);
  });
}

const SceneCamera& findCamera(const Scene& scene, const std::string& name) {
  if (scene.cameras.empty()) throw InputError(scene.file.string(), 0, "the scene has no camera");
  if (name.empty()) return scene.cameras.front();
  std::vector<std::string> names;
  for (const SceneCamera& camera : scene.cameras) {
    if (camera.name == name) return camera;
    names.push_back(camera.name);
  }
  const std::string nearest = nearestName(name, names);
  throw InputError(scene.file.string(), 0,
                   "no camera is called '" + name + "'" +
                       (nearest.empty() ? "; there is '" + names.front() + "'"
                                        : "; did you mean '" + nearest + "'?"));
}

}  // namespace seaway::bridge
