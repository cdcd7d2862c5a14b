#include "surface/geodesy.h"

#include <GeographicLib/AzimuthalEquidistant.hpp>
#include <GeographicLib/Geocentric.hpp>
#include <GeographicLib/Geodesic.hpp>
#include <GeographicLib/Geoid.hpp>
#include <algorithm>
#include <cmath>
#include <sstream>

#include "surface/angles.h"
#include "surface/input_error.h"

namespace seaway {
namespace {

using GeographicLib::AzimuthalEquidistant;
using GeographicLib::Geocentric;
using GeographicLib::Geodesic;

const AzimuthalEquidistant& projection() {
  static const AzimuthalEquidistant instance(Geodesic::WGS84());
  return instance;
}

SeaPlanePoint outOfRange(glm::dvec2 position) {
  SeaPlanePoint point;
  point.position = position;
  point.inRange = false;
  return point;
}

/// `azimuth_deg` is the geodesic's azimuth at the point, true north based; the plane's own azimuth
/// of the radius differs from it by the convergence.
SeaPlanePoint assemble(glm::dvec2 position, double azimuth_deg, double reciprocalScale) {
  SeaPlanePoint point;
  point.position = position;
  const double radius = glm::length(position);
  if (radius > 0.0) {
    const double planeAzimuth = std::atan2(position.x, position.y);
    point.convergence = std::remainder(radiansFromDegrees(azimuth_deg) - planeAzimuth, 2.0 * pi);
  }
  // Across the radius lengths grow by 1/rk; along it they are true.
  point.scaleError = 1.0 / reciprocalScale - 1.0;
  point.inRange = radius <= Geodesy::usableRange();
  return point;
}

}  // namespace

Geodesy::Geodesy(const GeodeticPosition& anchor) : anchor_(anchor) {
  if (!(anchor.latitude_deg >= -90.0 && anchor.latitude_deg <= 90.0)) {
    std::ostringstream message;
    message << "anchor latitude " << anchor.latitude_deg
            << " is not allowed; must be in [-90, 90] degrees";
    throw InputError(message.str());
  }
  if (!std::isfinite(anchor.longitude_deg) || !std::isfinite(anchor.height)) {
    throw InputError("anchor longitude and height must be finite");
  }
}

SeaPlanePoint Geodesy::seaPlaneFromGeodetic(double latitude_deg, double longitude_deg) const {
  const bool valid = std::abs(latitude_deg) <= 90.0 && std::isfinite(longitude_deg);
  if (!valid) return outOfRange(glm::dvec2(std::nan("")));
  double x, y, azimuth_deg, reciprocalScale;
  projection().Forward(anchor_.latitude_deg, anchor_.longitude_deg, latitude_deg, longitude_deg, x,
                       y, azimuth_deg, reciprocalScale);
  return assemble({x, y}, azimuth_deg, reciprocalScale);
}

GeodeticPosition Geodesy::geodeticFromSeaPlane(glm::dvec2 position) const {
  GeodeticPosition result;
  projection().Reverse(anchor_.latitude_deg, anchor_.longitude_deg, position.x, position.y,
                       result.latitude_deg, result.longitude_deg);
  return result;
}

SeaPlanePoint Geodesy::describe(glm::dvec2 position) const {
  if (!std::isfinite(position.x) || !std::isfinite(position.y)) return outOfRange(position);
  double latitude_deg, longitude_deg, azimuth_deg, reciprocalScale;
  projection().Reverse(anchor_.latitude_deg, anchor_.longitude_deg, position.x, position.y,
                       latitude_deg, longitude_deg, azimuth_deg, reciprocalScale);
  return assemble(position, azimuth_deg, reciprocalScale);
}

double Geodesy::directionFromTrueHeading(glm::dvec2 position, double heading_deg) const {
  return towardFromCompassToward(heading_deg) + describe(position).convergence;
}

double Geodesy::trueHeadingFromDirection(glm::dvec2 position, double direction) const {
  return compassTowardFromToward(direction - describe(position).convergence);
}

glm::dvec3 Geodesy::ecefFromGeodetic(const GeodeticPosition& position) {
  glm::dvec3 ecef;
  Geocentric::WGS84().Forward(position.latitude_deg, position.longitude_deg, position.height,
                              ecef.x, ecef.y, ecef.z);
  return ecef;
}

GeodeticPosition Geodesy::geodeticFromEcef(glm::dvec3 ecef) {
  GeodeticPosition position;
  Geocentric::WGS84().Reverse(ecef.x, ecef.y, ecef.z, position.latitude_deg, position.longitude_deg,
                              position.height);
  return position;
}

glm::dmat3 Geodesy::enuFromEcef(const GeodeticPosition& position) {
  double x, y, z;
  std::vector<double> ecefFromEnuRowMajor(9);
  Geocentric::WGS84().Forward(position.latitude_deg, position.longitude_deg, position.height, x, y,
                              z, ecefFromEnuRowMajor);
  // Row-major ECEF-from-ENU read as column-major is its transpose, the inverse of the rotation.
  glm::dmat3 rotation;
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) rotation[column][row] = ecefFromEnuRowMajor[3 * column + row];
  }
  return rotation;
}

struct SeaLevel::Geoid {
  GeographicLib::Geoid data;
};

SeaLevel::SeaLevel(double waterLevel, const std::string& geoidName) : waterLevel_(waterLevel) {
  try {
    geoid_.reset(new Geoid{GeographicLib::Geoid(geoidName, "", true, true)});
  } catch (const GeographicLib::GeographicErr&) {
    // Not installed: hasGeoid() says so.
  }
}

SeaLevel::~SeaLevel() = default;
SeaLevel::SeaLevel(SeaLevel&&) noexcept = default;
SeaLevel& SeaLevel::operator=(SeaLevel&&) noexcept = default;

double SeaLevel::ellipsoidalHeight(double latitude_deg, double longitude_deg) const {
  return waterLevel_ + (geoid_ ? geoid_->data(latitude_deg, longitude_deg) : 0.0);
}

}  // namespace seaway
