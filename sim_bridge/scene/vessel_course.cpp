#include "sim_bridge/scene/vessel_course.h"

#include "surface/angles.h"

namespace seaway::bridge {

Course courseOf(const SceneVessel& vessel, const Geodesy& geodesy) {
  const VesselStart& start = vessel.start;
  const glm::dvec2 place =
      geodesy.seaPlaneFromGeodetic(start.latitude_deg, start.longitude_deg).position;
  return Course(place, geodesy.directionFromTrueHeading(place, start.heading_deg), vessel.speed,
                -radiansFromDegrees(vessel.turn_deg));
}

}  // namespace seaway::bridge
