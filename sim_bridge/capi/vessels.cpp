#include <cmath>

#include "sim_bridge/capi/handles.h"
#include "sim_bridge/output/number_text.h"
#include "sim_bridge/scene/schema.h"
#include "surface/angles.h"

namespace seaway::bridge::capi {
namespace {

void write(const VesselPose& pose, const Geodesy& geodesy, seaway_pose& out) {
  const GeodeticPosition place = geodesy.geodeticFromSeaPlane(pose.position);
  out.east = pose.position.x;
  out.north = pose.position.y;
  out.latitude_deg = place.latitude_deg;
  out.longitude_deg = place.longitude_deg;
  out.height = pose.height;
  out.heading_deg = geodesy.trueHeadingFromDirection(pose.position, pose.direction);
  out.pitch_deg = degreesFromRadians(pose.pitch);
  out.roll_deg = degreesFromRadians(pose.roll);
}

VesselPose poseOf(const seaway_pose& given, const Geodesy& geodesy) {
  VesselPose pose;
  SeaPlanePoint point;
  requireThat(given.frame == SEAWAY_SEA_PLANE || given.frame == SEAWAY_GEODETIC, [&] {
    return "pose.frame is " + std::to_string(given.frame) +
           "; must be SEAWAY_SEA_PLANE (0) or SEAWAY_GEODETIC (1)";
  });
  if (given.frame == SEAWAY_GEODETIC) {
    point = geodesy.seaPlaneFromGeodetic(given.latitude_deg, given.longitude_deg);
  } else if (std::isfinite(given.east + given.north)) {
    point = geodesy.describe({given.east, given.north});
    point.position = {given.east, given.north};
  } else {
    point.inRange = false;
  }
  requireThat(point.inRange, "pose: the place is not finite, or not within 500 km of the anchor");
  requireThat(std::isfinite(given.height + given.heading_deg + given.pitch_deg + given.roll_deg),
              "pose.height, heading_deg, pitch_deg and roll_deg must be finite");
  pose.position = point.position;
  pose.direction = geodesy.directionFromTrueHeading(point.position, given.heading_deg);
  pose.height = given.height;
  pose.pitch = radiansFromDegrees(given.pitch_deg);
  pose.roll = radiansFromDegrees(given.roll_deg);
  return pose;
}

}  // namespace
}  // namespace seaway::bridge::capi

using namespace seaway::bridge;
using namespace seaway::bridge::capi;

extern "C" {

void seaway_pose_init(seaway_pose* pose, size_t size) { initialise(pose, size, seaway_pose{}); }

size_t seaway_sea_vessel_count(const seaway_sea* sea) {
  return sea ? seaOf(sea).scene().vessels.size() : 0;
}

const char* seaway_sea_vessel_name(const seaway_sea* sea, size_t vessel) {
  if (vessel >= seaway_sea_vessel_count(sea)) return nullptr;
  return seaOf(sea).scene().vessels[vessel].name.c_str();
}

seaway_status seaway_sea_find_vessel(const seaway_sea* handle, const char* name, size_t* vessel) {
  return guarded([&] {
    const CoupledSea& sea = seaOf(handle);
    require(name, "name");
    require(vessel, "vessel");
    std::vector<std::string> names;
    for (const SceneVessel& known : sea.scene().vessels) {
      if (known.name == name) {
        *vessel = names.size();
        return;
      }
      names.push_back(known.name);
    }
    const std::string nearest = nearestName(name, names);
    throw CallError(SEAWAY_NOT_FOUND,
                    "no vessel is called '" + std::string(name) + "'" +
                        (nearest.empty() ? "" : "; did you mean '" + nearest + "'?"));
  });
}

seaway_status seaway_sea_vessel_pose(const seaway_sea* handle, size_t vessel, seaway_pose* pose) {
  return guarded([&] {
    const CoupledSea& sea = seaOf(handle);
    requireVessel(sea, vessel);
    requireStruct(pose, "pose");
    write(sea.now()->poses[vessel], sea.geodesy(), *pose);
  });
}

seaway_status seaway_sea_place_vessel(seaway_sea* handle, size_t vessel, double time,
                                      const seaway_pose* pose) {
  return guarded([&] {
    CoupledSea& sea = seaOf(handle);
    requireVessel(sea, vessel);
    requireStruct(pose, "pose");
    requireThat(std::isfinite(time), "time is not finite");
    requireThat(sea.place(vessel, time, poseOf(*pose, sea.geodesy())), [&] {
      return "time is " + numberText(time) +
             " s; must be later than the vessel's last pose and not before the sea's time";
    });
  });
}

}  // extern "C"
