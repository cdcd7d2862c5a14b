#include "sim_bridge/scene/vessel_launch.h"

#include <algorithm>

#include "sim_bridge/scene/vessel_course.h"
#include "surface/angles.h"
#include "surface/input_error.h"

namespace seaway::bridge {
namespace {

bool isOff(const Scene& scene, Effect effect) {
  return scene.effects[static_cast<std::size_t>(effect)] == EffectSetting::off;
}

bool isDriven(const VesselModel& model) {
  return model.propeller.diameter > 0.0 && model.rudder.area > 0.0;
}

AutopilotSettings pilotOf(const SceneVessel& vessel, double length, const Geodesy& geodesy) {
  AutopilotSettings pilot{.waypoints = {}, .speed = vessel.speed, .shipLength = length};
  for (const Place& place : vessel.waypoints) {
    pilot.waypoints.push_back(
        geodesy.seaPlaneFromGeodetic(place.latitude_deg, place.longitude_deg).position);
  }
  return pilot;
}

}  // namespace

bool sailsFreely(const Scene& scene, const SceneVessel& vessel) {
  return vessel.motion == VesselMotion::free && !isOff(scene, Effect::hullLoads) &&
         !isOff(scene, Effect::vesselMotion);
}

bool anySailsFreely(const Scene& scene) {
  return std::any_of(scene.vessels.begin(), scene.vessels.end(),
                     [&](const SceneVessel& vessel) { return sailsFreely(scene, vessel); });
}

const char* whyUnsteered(const SceneVessel& vessel) {
  if (vessel.waypoints.empty() || isDriven(vessel.model)) return nullptr;
  return "has waypoints, but its model has no propeller and rudder";
}

std::optional<glm::dvec2> windOver(const Scene& scene, const Geodesy& geodesy) {
  const Wind& wind = scene.light.wind;
  if (!wind.from_deg) return std::nullopt;
  const double from = geodesy.directionFromTrueHeading(glm::dvec2(0.0), *wind.from_deg);
  return -wind.speed * unitVector(from);
}

FreeVessel launchFree(const Scene& scene, const SceneVessel& vessel, const Sea& sea) {
  if (const char* fault = whyUnsteered(vessel)) {
    throw InputError(scene.file.string(), 0, "vessel '" + vessel.name + "' " + fault);
  }
  const VesselModel& model = vessel.model;
  const auto mesh = vessel.mesh ? vessel.mesh : hullModelOf(model.mesh, model.hull);
  HullVesselSettings settings{.propeller = model.propeller, .rudder = model.rudder, .loads = {}};
  settings.loads.wind = windOver(scene, sea.geodesy);
  HullVessel body(mesh, settings);
  SceneVessel straight = vessel;
  straight.turn_deg = 0.0;
  const Course before = courseOf(straight, sea.geodesy);
  const CoursePoint start = before.at(0.0);
  body.place(start.position, start.direction, vessel.speed);
  if (isDriven(model)) body.setAutopilot(pilotOf(vessel, mesh->length(), sea.geodesy));
  return FreeVessel(std::move(body), before);
}

Vessel launch(const Scene& scene, const SceneVessel& vessel, const Sea& sea) {
  if (sailsFreely(scene, vessel)) return Vessel(launchFree(scene, vessel, sea));
  PrescribedVessel made(vessel.model.hull, courseOf(vessel, sea.geodesy));
  made.setCurrent(sea.surface.waves().settings().current);
  return Vessel(std::move(made));
}

}  // namespace seaway::bridge
