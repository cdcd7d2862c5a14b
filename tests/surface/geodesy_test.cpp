#include "surface/geodesy.h"

#include <gtest/gtest.h>

#include <GeographicLib/Geodesic.hpp>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <glm/geometric.hpp>

#include "surface/angles.h"
#include "surface/input_error.h"

namespace seaway {
namespace {

const GeodeticPosition canaveral{28.878, -78.467, 0.0};
const GeodeticPosition anchors[] = {canaveral,           {0.0, 0.0, 0.0},   {60.0, 5.0, 0.0},
                                    {-35.0, 180.0, 0.0}, {89.9, 20.0, 0.0}, {90.0, 0.0, 0.0},
                                    {-90.0, 45.0, 0.0}};

TEST(Geodesy, RoundTripsWithinAMicrometreOutTo500Kilometres) {
  for (const GeodeticPosition& anchor : anchors) {
    const Geodesy geodesy(anchor);
    for (const double radius : {0.0, 1.0, 1e3, 2e5, 4.999e5}) {
      for (int i = 0; i < 12; ++i) {
        const glm::dvec2 point = radius * unitVector(0.1 + i * pi / 6);
        const GeodeticPosition there = geodesy.geodeticFromSeaPlane(point);
        const SeaPlanePoint back =
            geodesy.seaPlaneFromGeodetic(there.latitude_deg, there.longitude_deg);
        // Issue: 1 mm within 200 km; degrees in double are spaced 2e-9 m, so a micrometre is
        // generous.
        EXPECT_LT(glm::distance(point, back.position), 1e-6)
            << anchor.latitude_deg << ' ' << radius;
        EXPECT_TRUE(back.inRange);
      }
    }
  }
}

TEST(Geodesy, DistanceAndAzimuthFromTheAnchorAreTheGeodesics) {
  const Geodesy geodesy(canaveral);
  double distance, azimuth_deg, end_deg;
  GeographicLib::Geodesic::WGS84().Inverse(28.878, -78.467, 29.9, -77.2, distance, azimuth_deg,
                                           end_deg);
  const SeaPlanePoint point = geodesy.seaPlaneFromGeodetic(29.9, -77.2);
  EXPECT_NEAR(glm::length(point.position), distance, 1e-6);
  EXPECT_NEAR(degreesFromRadians(std::atan2(point.position.x, point.position.y)), azimuth_deg,
              1e-10);
}

TEST(Geodesy, StatedScaleErrorIsWhatShortLinesShow) {
  const Geodesy geodesy(canaveral);
  const glm::dvec2 point(150e3, 130e3), across = glm::normalize(glm::dvec2(-130e3, 150e3));
  const GeodeticPosition a = geodesy.geodeticFromSeaPlane(point - 500.0 * across);
  const GeodeticPosition b = geodesy.geodeticFromSeaPlane(point + 500.0 * across);
  double metres;
  GeographicLib::Geodesic::WGS84().Inverse(a.latitude_deg, a.longitude_deg, b.latitude_deg,
                                           b.longitude_deg, metres);
  EXPECT_NEAR(1000.0 / metres - 1.0, geodesy.describe(point).scaleError, 1e-8);
  // Asked: at most 5e-4 within 200 km.
  EXPECT_LT(geodesy.describe(200e3 * unitVector(0.3)).scaleError, 1.7e-4);
}

TEST(Geodesy, TrueHeadingsTurnAgainstTheGridAwayFromTheAnchor) {
  const Geodesy geodesy({60.0, 5.0, 0.0});
  const glm::dvec2 east(150e3, 0.0);
  // Moving true north by a metre must move along the direction stated for heading 0.
  const GeodeticPosition here = geodesy.geodeticFromSeaPlane(east);
  const SeaPlanePoint north =
      geodesy.seaPlaneFromGeodetic(here.latitude_deg + 1e-5, here.longitude_deg);
  const glm::dvec2 moved = glm::normalize(north.position - east);
  const double direction = geodesy.directionFromTrueHeading(east, 0.0);
  EXPECT_NEAR(glm::dot(moved, unitVector(direction)), 1.0, 1e-9);
  // Meridian convergence: grid convergence is 2.3° at 150 km, 60° N.
  EXPECT_NEAR(std::abs(degreesFromRadians(geodesy.describe(east).convergence)), 2.3, 0.05);
  EXPECT_NEAR(geodesy.trueHeadingFromDirection(east, direction), 0.0, 1e-9);
  EXPECT_NEAR(geodesy.trueHeadingFromDirection(east, geodesy.directionFromTrueHeading(east, 211.0)),
              211.0, 1e-9);
}

TEST(Geodesy, FramesAreRightHandedAndUpIsTheEllipsoidsNormal) {
  const GeodeticPosition place{52.0, 4.0, 100.0};
  const glm::dmat3 enuFromEcef = Geodesy::enuFromEcef(place);
  const glm::dvec3 below = Geodesy::ecefFromGeodetic({52.0, 4.0, 0.0});
  const glm::dvec3 up = enuFromEcef * (Geodesy::ecefFromGeodetic(place) - below);
  // ECEF coordinates of 6e6 m are spaced 1e-9 m in double.
  EXPECT_NEAR(glm::distance(up, glm::dvec3(0, 0, 100)), 0.0, 1e-8);
  const glm::dvec3 north = enuFromEcef * (Geodesy::ecefFromGeodetic({52.00001, 4.0, 0.0}) - below);
  EXPECT_GT(north.y, 1.0);
  EXPECT_NEAR(north.x, 0.0, 1e-8);
  const GeodeticPosition back = Geodesy::geodeticFromEcef(Geodesy::ecefFromGeodetic(place));
  EXPECT_NEAR(back.height, 100.0, 1e-8);
}

TEST(Geodesy, SeaLevelIsTheWaterLevelWhereNoGeoidIsInstalled) {
  const SeaLevel level(0.7, "no-such-geoid");
  EXPECT_FALSE(level.hasGeoid());
  EXPECT_DOUBLE_EQ(level.ellipsoidalHeight(28.878, -78.467), 0.7);
}

/// Writes a geoid of constant height in GeographicLib's PGM format on a 10° grid.
void writeConstantGeoid(const std::filesystem::path& folder, double height) {
  std::filesystem::create_directories(folder);
  std::ofstream file(folder / "flat.pgm", std::ios::binary);
  file << "P5\n# Geoid file in PGM format\n# Description constant\n# DateTime 2026-01-01\n"
       << "# MaxBilinearError 0\n# RMSBilinearError 0\n# MaxCubicError 0\n# RMSCubicError 0\n"
       << "# Offset -108\n# Scale 0.003\n36 19\n65535\n";
  const auto pixel = static_cast<unsigned>(std::lround((height + 108.0) / 0.003));
  for (int i = 0; i < 36 * 19; ++i)
    file.put(static_cast<char>(pixel >> 8)).put(static_cast<char>(pixel & 255));
}

TEST(Geodesy, SeaLevelAddsTheGeoidWhereItsDataAreInstalled) {
  const auto folder = std::filesystem::temp_directory_path() / "seaway_geoid_test";
  writeConstantGeoid(folder, -30.0);
  setenv("GEOGRAPHICLIB_GEOID_PATH", folder.c_str(), 1);
  const SeaLevel level(0.5, "flat");
  unsetenv("GEOGRAPHICLIB_GEOID_PATH");
  ASSERT_TRUE(level.hasGeoid());
  EXPECT_NEAR(level.ellipsoidalHeight(28.878, -78.467), -29.5,
              1e-6);  // the format's step is 3 mm: −30 is one
  std::filesystem::remove_all(folder);
}

TEST(GeodesyHard, BeyondTheUsableRangeAStatusInsteadOfAGuess) {
  const Geodesy geodesy(canaveral);
  EXPECT_FALSE(geodesy.seaPlaneFromGeodetic(60.0, 5.0).inRange);
  EXPECT_FALSE(geodesy.seaPlaneFromGeodetic(NAN, 5.0).inRange);
  EXPECT_FALSE(geodesy.seaPlaneFromGeodetic(91.0, 5.0).inRange);
  EXPECT_FALSE(geodesy.seaPlaneFromGeodetic(20.0, INFINITY).inRange);
}

TEST(GeodesyHard, AnchorsOutsideTheGlobeAreRejected) {
  EXPECT_THROW(Geodesy({91.0, 0.0, 0.0}), InputError);
  EXPECT_THROW(Geodesy({NAN, 0.0, 0.0}), InputError);
  EXPECT_THROW(Geodesy({0.0, NAN, 0.0}), InputError);
}

TEST(GeodesyHard, TheAntimeridianIsNoSeam) {
  const Geodesy geodesy({-17.0, 179.999, 0.0});
  const SeaPlanePoint west = geodesy.seaPlaneFromGeodetic(-17.0, 179.9999);
  const SeaPlanePoint east = geodesy.seaPlaneFromGeodetic(-17.0, -179.9999);
  EXPECT_LT(glm::distance(west.position, east.position), 25.0);  // 2e-4 degrees
  EXPECT_GT(east.position.x, west.position.x);
}

}  // namespace
}  // namespace seaway
