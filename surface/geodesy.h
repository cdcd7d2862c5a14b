#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <string>

namespace seaway {

/// Position on WGS84: degrees, and metres above the ellipsoid.
struct GeodeticPosition {
  double latitude_deg = 0.0;   ///< [-90, 90]
  double longitude_deg = 0.0;  ///< any; brought into [-180, 180] on output
  double height = 0.0;         ///< m above the ellipsoid
};

/// A point of the sea plane and what the map does there.
struct SeaPlanePoint {
  glm::dvec2 position{0.0};  ///< m, x east and y north at the anchor
  double convergence = 0.0;  ///< rad counter-clockwise from the plane's +y to true north there
  double scaleError = 0.0;   ///< largest |map length / true length − 1| over all directions
  bool inRange = true;       ///< within Geodesy::usableRange() of the anchor
};

/// Maps WGS84 to the *sea plane*, the local frame in which waves, vessels and wakes live.
///
/// The sea plane is the azimuthal equidistant projection about the scene's anchor: distance and
/// azimuth from the anchor are those of the geodesic. Lengths along the radius are true; across
/// it they are too long by about (s/R)²/6 at distance s: 1.7e-4 at 200 km, 1.03e-3 at 500 km
/// (`scaleError` gives the value at a point). Round trips agree within 1e-6 m up to 500 km
/// (tests/surface/geodesy_test.cpp). Poles and the antimeridian are ordinary anchors; at a pole
/// "north" of the plane is the direction the anchor's longitude defines.
///
/// Source: C. F. F. Karney, Algorithms for geodesics, J. Geodesy 87, 43–55 (2013),
/// doi:10.1007/s00190-012-0578-z, through GeographicLib. Immutable and thread-safe.
class Geodesy {
 public:
  /// Throws InputError unless latitude is in [-90, 90] and all three numbers are finite.
  explicit Geodesy(const GeodeticPosition& anchor);

  const GeodeticPosition& anchor() const { return anchor_; }

  /// Distance from the anchor up to which answers are given, m.
  static constexpr double usableRange() { return 500e3; }

  /// Sea-plane point below a geodetic position. Non-finite input gives `inRange == false`.
  SeaPlanePoint seaPlaneFromGeodetic(double latitude_deg, double longitude_deg) const;

  /// Geodetic position of a sea-plane point; height 0.
  GeodeticPosition geodeticFromSeaPlane(glm::dvec2 position) const;

  /// Convergence, scale and range at a sea-plane point.
  SeaPlanePoint describe(glm::dvec2 position) const;

  /// Direction in the sea plane (rad counter-clockwise from +x) of a true compass heading at
  /// `position`; the plane's grid turns against true north away from the anchor.
  double directionFromTrueHeading(glm::dvec2 position, double heading_deg) const;

  /// True compass heading in [0, 360) of a sea-plane direction at `position`.
  double trueHeadingFromDirection(glm::dvec2 position, double direction) const;

  static glm::dvec3 ecefFromGeodetic(const GeodeticPosition& position);
  static GeodeticPosition geodeticFromEcef(glm::dvec3 ecef);

  /// Rotation taking ECEF vectors to east, north, up at `position`.
  static glm::dmat3 enuFromEcef(const GeodeticPosition& position);

 private:
  GeodeticPosition anchor_;
};

/// Height of the still-water level above the WGS84 ellipsoid.
///
/// geoid undulation + water level (tide and set-up). The undulation comes from GeographicLib's
/// geoid data where they are installed (GEOGRAPHICLIB_GEOID_PATH or the library's default); where
/// they are not, the still-water level is taken to be `water level` above the ellipsoid itself and
/// `hasGeoid()` is false. Thread-safe.
class SeaLevel {
 public:
  /// `geoidName` such as "egm96-5" or "egm2008-1". Missing data are not an error.
  explicit SeaLevel(double waterLevel, const std::string& geoidName = "egm96-5");
  ~SeaLevel();
  SeaLevel(SeaLevel&&) noexcept;
  SeaLevel& operator=(SeaLevel&&) noexcept;

  bool hasGeoid() const { return geoid_ != nullptr; }

  /// Ellipsoidal height of the still-water level at a place, m.
  double ellipsoidalHeight(double latitude_deg, double longitude_deg) const;

 private:
  struct Geoid;
  double waterLevel_;
  std::unique_ptr<Geoid> geoid_;
};

}  // namespace seaway
