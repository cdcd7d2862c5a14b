#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "sim_bridge/service/shm_service.h"
#include "sim_bridge/shm/seaway_shm.hpp"
#include "tests/sim_bridge/service/served_waters.h"
#include "tests/sim_bridge/shm/known_sea.h"

// A scene's sea through the shared memory.
namespace seaway::bridge::shm {
namespace {

using seaway::bridge::test::pilotScene;
using seaway::bridge::test::sceneText;
using seaway::bridge::test::ServedWaters;
using seaway::shm::Client;

/// A scene that is served, and a host of it.
struct Served {
  explicit Served(const std::string& text) : waters(text) {
    endpoint->start();
    host = std::make_unique<Client>(options.name);
  }
  ServedWaters waters;
  FrameMaker frames{waters.sea};
  ShmServiceOptions options{.name = test::uniqueName(), .hosts = 4, .points = 2000};
  std::unique_ptr<Endpoint> endpoint =
      makeShmEndpoint(options, waters.sea, ServeClock::parse("--clock", "host"), frames);
  std::unique_ptr<Client> host;
};

std::string wavesAlone() { return sceneText({{"run:", "effects: {wake: off}\nrun:"}}); }

struct Points {
  std::vector<double> x, y;
};
Points scattered(std::size_t count) {
  Points made;
  for (std::size_t i = 0; i < count; ++i) {
    const double n = static_cast<double>(i);
    made.x.push_back(300.0 * std::sin(1.7 * n));
    made.y.push_back(300.0 * std::cos(2.3 * n));
  }
  return made;
}

TEST(ShmSea, PointsOfTheSeaPlaneGetTheBitsOfTheSurfaceItself) {
  Served served(wavesAlone());
  const Points points = scattered(1500);
  const auto surface = served.waters.sea.surface();
  for (const double t : {0.0, 12.5, -4.0}) {
    SampleOptions options{.tolerance = 0.02, .shortestWavelength = 3.0, .orbitalVelocity = true};
    const auto got = served.host->sample(
        points.x, points.y,
        {.time = t, .tolerance = 0.02, .shortestWavelength = 3.0, .orbitalVelocity = true});
    for (std::size_t i = 0; i < points.x.size(); ++i) {
      const SurfaceSample sample = surface->sample({points.x[i], points.y[i]}, t, options);
      ASSERT_EQ(got.height[i], sample.height);
      ASSERT_EQ(got.slopeEast[i], sample.slope.x);
      ASSERT_EQ(got.slopeNorth[i], sample.slope.y);
      ASSERT_EQ(got.verticalVelocity[i], sample.verticalVelocity);
      ASSERT_EQ(got.orbitalEast[i], sample.orbitalVelocity.x);
      ASSERT_EQ(got.orbitalNorth[i], sample.orbitalVelocity.y);
      ASSERT_EQ(got.orbitalUp[i], sample.orbitalVelocity.z);
      ASSERT_EQ(got.error[i], sample.error);
      ASSERT_EQ(got.bound[i], sample.bound);
      ASSERT_EQ(got.status[i], static_cast<std::uint32_t>(sample.status));
    }
  }
}

TEST(ShmSea, GeodeticPointsAreWhereTheyAreAndTheirSlopesTrue) {
  Served served(wavesAlone());
  const Geodesy& geodesy = served.waters.sea.geodesy();
  const auto surface = served.waters.sea.surface();
  // Two degrees east of the anchor, where true north is not the plane's.
  const auto& anchor = served.waters.scene.sea.anchor;
  Points points;
  for (int i = 0; i < 100; ++i) {
    points.x.push_back(anchor.longitude_deg + 2.0 + 1e-5 * i);
    points.y.push_back(anchor.latitude_deg + 2e-5 * i);
  }
  const auto got = served.host->sample(points.x, points.y, {.time = 3.0, .geodetic = true});
  double turned = 0.0;
  for (std::size_t i = 0; i < points.x.size(); ++i) {
    const SeaPlanePoint place = geodesy.seaPlaneFromGeodetic(points.y[i], points.x[i]);
    const SurfaceSample sample = surface->sample(place.position, 3.0);
    // Half a millimetre of place (PlanePlacer), on slopes and their rates below 1.
    EXPECT_NEAR(got.height[i], sample.height, 5e-4);
    const double c = std::cos(place.convergence), s = std::sin(place.convergence);
    EXPECT_NEAR(got.slopeEast[i], c * sample.slope.x + s * sample.slope.y, 1e-3);
    EXPECT_NEAR(got.slopeNorth[i], c * sample.slope.y - s * sample.slope.x, 1e-3);
    turned = std::max(turned, std::abs(s));
  }
  EXPECT_GT(turned, 0.01) << "the place is no test of turning";
}

TEST(ShmSea, AHostsHullMakesWavesThatItDoesNotFeelItselfAndThatSaySoUntilTheyAreThere) {
  Served served(pilotScene("", "0"));
  Client& host = *served.host;
  const std::uint32_t hull = host.addHull(0);
  const auto poseAt = [&](double t) {
    const HostedPose at = served.waters.poseAt({0.0, 5.0 * t});
    seaway::shm::Pose pose{};
    pose.hull = hull;
    pose.latitude_deg = at.latitude_deg, pose.longitude_deg = at.longitude_deg;
    return pose;
  };
  for (int i = 0; i <= 160; ++i) {
    const auto pose = poseAt(0.1 * i);
    host.placeHulls(0.1 * i, std::span(&pose, 1));
  }
  Points line;
  for (int i = 0; i < 200; ++i) line.x.push_back(-20.0 + 0.2 * i), line.y.push_back(66.0);
  const auto highest = [&](std::uint32_t own) {
    const auto got = host.sample(line.x, line.y, {.time = 15.0, .ownHull = own});
    double most = 0.0;
    for (const double height : got.height) most = std::max(most, std::abs(height));
    return std::pair(most, got.status[100]);
  };
  EXPECT_NE(highest(0).second & SEAWAY_SHM_POINT_WAKE_OUT_OF_TIME, 0u);
  ASSERT_TRUE(served.waters.sea.awaitWakes(60.0));  // so long that something hangs
  const auto [felt, status] = highest(0);
  EXPECT_GT(felt, 0.02);
  EXPECT_EQ(status & SEAWAY_SHM_POINT_WAKE_OUT_OF_TIME, 0u);
  EXPECT_LT(highest(hull).first, 1e-6);
  seaway_shm_batch batch;
  ASSERT_EQ(seaway_shm_begin(&host.c(), SEAWAY_SHM_DESCRIBE, &batch), SEAWAY_SHM_OK);
  ASSERT_EQ(seaway_shm_call(&host.c(), &batch), SEAWAY_SHM_OK);
  EXPECT_LE(batch.answer->wakes_from, 15.0);
  EXPECT_GE(batch.answer->wakes_to, 15.0);
}

TEST(ShmSea, PicturesAreThoseOfTheFrameMaker) {
  Served served(pilotScene());
  seaway_shm_picture_request asked{};
  std::snprintf(asked.camera, sizeof asked.camera, "mast");
  asked.time = 2.0;
  served.host->askPicture(asked);
  const auto got = served.host->waitPicture(60.0);
  const auto truth = served.frames.draw({.camera = "mast", .t = 2.0});
  ASSERT_EQ(got.width, 96u);
  ASSERT_EQ(got.height, 64u);
  EXPECT_TRUE(std::equal(got.rgb.begin(), got.rgb.end(), truth->colour.rgb.begin(),
                         truth->colour.rgb.end()));
  EXPECT_TRUE(std::equal(got.depth.begin(), got.depth.end(), truth->depth.metres.begin(),
                         truth->depth.metres.end()));
  asked.flags = SEAWAY_SHM_OWN_CAMERA;
  asked.eye_height = 40.0;
  asked.pitch_deg = -30.0;
  asked.vertical_field_deg = 60.0;
  served.host->askPicture(asked);
  const auto own = served.host->waitPicture(60.0);
  EXPECT_TRUE(std::equal(own.rgb.begin(), own.rgb.end(), truth->colour.rgb.begin(),
                         truth->colour.rgb.end()))
      << "a camera that stands where the scene's does";
}

TEST(ShmSea, TheDescriptionNamesTheSceneAndWhatIsInIt) {
  Served served(pilotScene());
  const auto described = nlohmann::json::parse(served.host->describe());
  EXPECT_EQ(described["vessels"][0]["name"], "pilot");
  EXPECT_EQ(described["cameras"][1]["name"], "mast");
  EXPECT_TRUE(described["sea"]["depth_m"].is_null());
  EXPECT_EQ(described["anchor"]["latitude_deg"], 0.0);
}

TEST(ShmSeaHard, WhatCannotBeIsRefusedNamedAndCounted) {
  Served served(pilotScene());
  Client& host = *served.host;
  const auto refused = [&](auto call, seaway_shm_status status, const std::string& word) {
    try {
      call();
      ADD_FAILURE() << word;
    } catch (const seaway::shm::Error& error) {
      EXPECT_EQ(error.status(), status);
      EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
    }
  };
  refused([&] { host.addHull(2); }, SEAWAY_SHM_NOT_FOUND, "no vessel 2; it has 2");
  const std::uint32_t hull = host.addHull(0);
  Client other(served.options.name);
  seaway::shm::Pose pose{};
  pose.hull = hull;
  const auto place = [&](Client& client, double t) { client.placeHulls(t, std::span(&pose, 1)); };
  refused([&] { place(other, 0.0); }, SEAWAY_SHM_NOT_FOUND, "no hull");
  refused([&] { other.removeHull(hull); }, SEAWAY_SHM_NOT_FOUND, "no hull");
  refused([&] { place(host, NAN); }, SEAWAY_SHM_BAD_VALUE, "time of poses");
  place(host, 1.0);
  refused([&] { place(host, 0.5); }, SEAWAY_SHM_BAD_VALUE, "not after its last");
  pose.roll_deg = NAN;
  refused([&] { place(host, 2.0); }, SEAWAY_SHM_BAD_VALUE, "roll_deg");
  seaway_shm_picture_request asked{};
  std::snprintf(asked.camera, sizeof asked.camera, "keel");
  refused([&] { host.askPicture(asked), host.waitPicture(60.0); }, SEAWAY_SHM_BAD_VALUE, "keel");
  const MeterCounts counts = served.waters.sea.meters().of("shm").read();
  EXPECT_EQ(counts.refusals[static_cast<std::size_t>(Refusal::notFound)], 3u);
  EXPECT_EQ(counts.refusals[static_cast<std::size_t>(Refusal::badValue)], 4u);
}

TEST(ShmSeaHard, AHostThatLeavesTakesItsHullsOutOfTheSea) {
  Served served(pilotScene());
  const std::uint32_t hull = served.host->addHull(1);
  seaway::shm::Pose pose{};
  pose.hull = hull;
  served.host->placeHulls(0.0, std::span(&pose, 1));
  const auto hosted = [&] { return served.waters.sea.hulls(0.0).at(1).hull; };
  EXPECT_EQ(hosted(), hull);
  served.host.reset();
  EXPECT_TRUE(test::comesTrue([&] { return hosted() == 0; }));
}

}  // namespace
}  // namespace seaway::bridge::shm
