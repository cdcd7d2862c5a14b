#include "sim_bridge/cigi/sea_water.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "sim_bridge/scene/scene_loader.h"
#include "surface/angles.h"
#include "tests/sim_bridge/test_support.h"

namespace seaway::bridge::cigi {
namespace {

using test::TempFolder;

using Changes = std::vector<std::pair<std::string, std::string>>;

/// A scene's sea, in the water of the test support's scene unless another file is named.
class Served {
 public:
  explicit Served(const Changes& replacements = {})
      : scene_(loadScene(test::writeScene(folder_, replacements))) {}
  /// Of a scene of configs/scenes.
  Served(std::in_place_t, const std::string& name)
      : scene_(loadScene(std::string(SEAWAY_SOURCE_DIR) + "/configs/scenes/" + name)) {}

  const Scene& scene() const { return scene_; }

 private:
  TempFolder folder_;
  Scene scene_;

 public:
  ServedSea sea{scene_, buildSea(scene_)};
  SeaWater water{sea};

  WaterHeight height(double t, const WaterPoint& point) {
    WaterHeight out;
    water.heights(t, std::span(&point, 1), std::span(&out, 1));
    return out;
  }
  WaterVelocity velocity(double t, const WaterPoint& point) {
    WaterVelocity out;
    water.velocities(t, std::span(&point, 1), std::span(&out, 1));
    return out;
  }
};

constexpr double anchorLatitude = 28.878, anchorLongitude = -78.467;

TEST(CigiSeaWater, HeightsAreTheSurfacesOwnAtPointsInThePlane) {
  Served served;
  const auto surface = served.sea.surface();
  std::vector<WaterPoint> points;
  for (int i = 0; i < 40; ++i) {
    points.push_back({anchorLatitude + 0.02 * std::sin(i), anchorLongitude + 0.02 * std::cos(i)});
  }
  std::vector<WaterHeight> out(points.size());
  served.water.heights(12.5, points, out);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const glm::dvec2 place =
        served.sea.geodesy()
            .seaPlaneFromGeodetic(points[i].latitude_deg, points[i].longitude_deg)
            .position;
    EXPECT_TRUE(out[i].valid);
    // Half a millimetre of place, on slopes below 1.
    EXPECT_NEAR(out[i].elevation, surface->sample(place, 12.5).height, 5e-4);
  }
}

// 2 mm of place (PlanePlacer), on slopes below 1.
TEST(CigiSeaWater, OffsetsAreTrueEastAndNorthFarFromTheAnchor) {
  Served served;
  const GeodeticPosition base = served.sea.geodesy().geodeticFromSeaPlane({80e3, 60e3});
  const glm::dmat3 enu = Geodesy::enuFromEcef(base);
  for (const glm::dvec2 offset : {glm::dvec2(60, 0), glm::dvec2(0, 60), glm::dvec2(-30, 45)}) {
    const glm::dvec3 ecef =
        Geodesy::ecefFromGeodetic(base) + glm::transpose(enu) * glm::dvec3(offset, 0.0);
    const GeodeticPosition there = Geodesy::geodeticFromEcef(ecef);
    const WaterHeight byOffset =
        served.height(3.0, {base.latitude_deg, base.longitude_deg, offset.x, offset.y});
    const WaterHeight direct = served.height(3.0, {there.latitude_deg, there.longitude_deg});
    EXPECT_NEAR(byOffset.elevation, direct.elevation, 0.002);
  }
}

TEST(CigiSeaWater, SlopesAreTowardsTrueEastAndNorth) {
  Served served;
  const GeodeticPosition base = served.sea.geodesy().geodeticFromSeaPlane({-300e3, 200e3});
  const auto at = [&](double east, double north) {
    return served.height(9.0, {base.latitude_deg, base.longitude_deg, east, north});
  };
  const double d = 0.05;
  // Central differences err by d²/6 times the third derivative, below 1e-3 for waves over 3 m.
  EXPECT_NEAR(at(0, 0).slopeEast, (at(d, 0).elevation - at(-d, 0).elevation) / (2 * d), 1e-3);
  EXPECT_NEAR(at(0, 0).slopeNorth, (at(0, d).elevation - at(0, -d).elevation) / (2 * d), 1e-3);
}

TEST(CigiSeaWaterHard, AshoreFarAwayAndNotANumberAreNotValid) {
  Served served(std::in_place, "crater_lake.yaml");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(served.height(1.0, {42.94, -122.11}).valid);
  EXPECT_TRUE(served.velocity(1.0, {42.94, -122.11, 0, 0, -2.0}).valid);
  for (const WaterPoint& point :
       {WaterPoint{42.94, -122.30}, WaterPoint{20.0, -122.11}, WaterPoint{-42.94, 57.89},
        WaterPoint{nan, -122.11}, WaterPoint{42.94, nan}, WaterPoint{1e300, 1e300},
        WaterPoint{42.94, -122.11, nan, 0}, WaterPoint{42.94, -122.11, 1e300, 0}}) {
    EXPECT_FALSE(served.height(1.0, point).valid) << point.latitude_deg;
    WaterPoint deep = point;
    deep.height = -2.0;
    EXPECT_FALSE(served.velocity(1.0, deep).valid) << point.latitude_deg;
  }
  for (const double t : {nan, std::numeric_limits<double>::infinity(), 1e300}) {
    EXPECT_FALSE(served.height(t, {42.94, -122.11}).valid);
    EXPECT_FALSE(served.velocity(t, {42.94, -122.11, 0, 0, -2.0}).valid);
  }
}

TEST(CigiSeaWater, VelocitiesAreOrbitalOnesAndTheCurrentAndNoneInTheAir) {
  Served served(
      Changes{{"  seed: 7\n", "  seed: 7\n  current: {speed_m_s: 1.5, toward_deg: 90}\n"}});
  const auto surface = served.sea.surface();
  const glm::dvec3 point(0.0, 0.0, -3.0);
  WaterKinematics motion;
  sampleKinematics(surface->at(4.0), std::span(&point, 1), std::span(&motion, 1));
  const WaterVelocity water = served.velocity(4.0, {anchorLatitude, anchorLongitude, 0, 0, -3.0});
  ASSERT_TRUE(water.valid);
  // The anchor is placed within nanometres, and single precision is within 1e-5 of σω.
  EXPECT_NEAR(water.velocity.x, motion.velocity.x + 1.5, 1e-6);
  EXPECT_NEAR(water.velocity.y, motion.velocity.y, 1e-6);
  EXPECT_NEAR(water.velocity.z, motion.velocity.z, 1e-6);
  EXPECT_NEAR(water.elevation, motion.surfaceHeight, 1e-6);
  EXPECT_FALSE(served.velocity(4.0, {anchorLatitude, anchorLongitude, 0, 0, 30.0}).valid);
}

TEST(CigiSeaWater, AHostsWavesTakeTheSeasPlaceUntilItHasNone) {
  Served served;
  const WaterPoint anchor{anchorLatitude, anchorLongitude};
  const double before = served.height(7.0, anchor).elevation;
  const HostWave swell{.height = 2.0, .period = 8.0, .toward_deg = 90.0, .phase_deg = 30.0};
  served.water.wavesAsked(1, 0.0, std::span(&swell, 1));
  const double omega = 2.0 * pi / 8.0;
  const double k = omega * omega / 9.80665;
  for (const double t : {0.0, 1.0, 7.0}) {
    for (const double east : {0.0, 13.0}) {
      WaterPoint point = anchor;
      point.east = east;
      // The field is computed in single precision: 1e-5 of its height.
      EXPECT_NEAR(served.height(t, point).elevation,
                  std::cos(k * east - omega * t + radiansFromDegrees(30.0)), 2e-5);
    }
  }
  const HostWave byLength{.height = 2.0, .wavelength = 2.0 * pi / k, .toward_deg = 90.0};
  served.water.wavesAsked(1, 0.0, std::span(&byLength, 1));
  EXPECT_NEAR(served.height(3.0, anchor).elevation, std::cos(omega * 3.0), 2e-5);
  served.water.wavesAsked(1, 0.0, {});
  EXPECT_EQ(served.height(7.0, anchor).elevation, before);
}

TEST(CigiSeaWaterHard, WavesThatAreNoFieldLeaveTheSeaAsItWas) {
  Served served;
  const WaterPoint anchor{anchorLatitude, anchorLongitude};
  const double before = served.height(7.0, anchor).elevation;
  for (const HostWave& wave :
       {HostWave{.height = 2.0, .period = 1e-300}, HostWave{.height = 1e308, .wavelength = 1e-308},
        HostWave{.height = 2.0, .period = 1e300}}) {
    served.water.wavesAsked(1, 0.0, std::span(&wave, 1));
    const WaterHeight after = served.height(7.0, anchor);
    EXPECT_TRUE(after.valid);
    EXPECT_EQ(after.elevation, before);
  }
}

// A launch is sailed north at 6 m/s by the host for 20 s over still water: astern of it the water
// moves, for others and not for its own points.
TEST(CigiSeaWater, AHostsHullLeavesAWakeThatItDoesNotFeelItself) {
  Served served(
      Changes{{"jonswap:\n      hm0_m: 1.12\n      tp_s: 5.6\n      from_deg: 196", "calm: {}"}});
  WaterPoint astern{anchorLatitude, anchorLongitude};
  double felt = 0.0;
  double own = 0.0;
  for (int step = 0; step <= 200; ++step) {
    const double t = 0.1 * step;
    const double north = 6.0 * t;
    const GeodeticPosition at = served.sea.geodesy().geodeticFromSeaPlane({0.0, north});
    const HostEntity ship{.entity = 0, .place = {at.latitude_deg, at.longitude_deg}};
    served.water.entitiesAt(1, t, std::span(&ship, 1));
    std::vector<WaterPoint> points(24, WaterPoint{at.latitude_deg, at.longitude_deg});
    for (std::size_t i = 0; i < points.size(); ++i) {
      points[i].north = -15.0 - 2.0 * static_cast<double>(i % 12);
      if (i >= 12) points[i].host = 1;
    }
    std::vector<WaterHeight> out(points.size());
    served.water.heights(t, points, out);
    EXPECT_TRUE(served.sea.awaitWakes(60.0));
    for (std::size_t i = 0; i < points.size(); ++i) {
      ASSERT_TRUE(out[i].valid);
      double& most = i < 12 ? felt : own;
      most = std::max(most, std::abs(out[i].elevation));
    }
  }
  EXPECT_GT(felt, 0.05);
  EXPECT_EQ(own, 0.0);
  served.water.hostGone(1);
  EXPECT_TRUE(served.height(20.1, astern).valid);
}

}  // namespace
}  // namespace seaway::bridge::cigi
