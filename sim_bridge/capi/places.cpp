#include <cmath>
#include <limits>

#include "sim_bridge/capi/handles.h"
#include "sim_bridge/capi/prepared_water.h"
#include "surface/angles.h"

using namespace seaway::bridge;
using namespace seaway::bridge::capi;

namespace {
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
}

extern "C" {

seaway_status seaway_sea_plane_from_geodetic(const seaway_sea* handle, size_t count,
                                             const double* latitude_deg,
                                             const double* longitude_deg, double* east,
                                             double* north, double* convergence_deg) {
  return guarded([&] {
    const CoupledSea& sea = seaOf(handle);
    if (count == 0) return;
    require(latitude_deg, "latitude_deg");
    require(longitude_deg, "longitude_deg");
    require(east, "east");
    require(north, "north");
    PlanePlacer& placer = placerOf(sea);
    for (size_t i = 0; i < count; ++i) {
      const PlacedPoint point = placer.place(latitude_deg[i], longitude_deg[i]);
      east[i] = point.position.x;
      north[i] = point.position.y;
      if (!convergence_deg) continue;
      convergence_deg[i] = std::isnan(point.position.x)
                               ? unknown
                               : seaway::degreesFromRadians(std::atan2(point.turn.y, point.turn.x));
    }
  });
}

seaway_status seaway_sea_geodetic_from_plane(const seaway_sea* handle, size_t count,
                                             const double* east, const double* north,
                                             double* latitude_deg, double* longitude_deg) {
  return guarded([&] {
    const CoupledSea& sea = seaOf(handle);
    if (count == 0) return;
    require(east, "east");
    require(north, "north");
    require(latitude_deg, "latitude_deg");
    require(longitude_deg, "longitude_deg");
    for (size_t i = 0; i < count; ++i) {
      seaway::GeodeticPosition place{unknown, unknown, 0.0};
      // NaN compares false.
      if (std::hypot(east[i], north[i]) <= seaway::Geodesy::usableRange()) {
        place = sea.geodesy().geodeticFromSeaPlane({east[i], north[i]});
      }
      latitude_deg[i] = place.latitude_deg;
      longitude_deg[i] = place.longitude_deg;
    }
  });
}

seaway_status seaway_sea_still_water_level(const seaway_sea* handle, size_t count,
                                           const double* latitude_deg, const double* longitude_deg,
                                           double* ellipsoidal_height) {
  return guarded([&] {
    const CoupledSea& sea = seaOf(handle);
    if (count == 0) return;
    require(latitude_deg, "latitude_deg");
    require(longitude_deg, "longitude_deg");
    require(ellipsoidal_height, "ellipsoidal_height");
    for (size_t i = 0; i < count; ++i) {
      const bool sound = std::abs(latitude_deg[i]) <= 90.0 && std::isfinite(longitude_deg[i]);
      ellipsoidal_height[i] =
          sound ? sea.level().ellipsoidalHeight(latitude_deg[i], longitude_deg[i]) : unknown;
    }
  });
}

}  // extern "C"
