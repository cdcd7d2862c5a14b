#include "sim_bridge/service/served_sea.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "sim_bridge/scene_detail.h"
#include "sim_bridge/simulation.h"
#include "surface/angles.h"
#include "tests/sim_bridge/service/served_waters.h"

namespace seaway::bridge {
namespace {

using test::largestWave;
using test::pilotScene;
using test::ServedWaters;

TEST(ServedSea, VesselsThatNoHostPlacesSailTheScenesCourse) {
  ServedWaters served;
  const auto hulls = served.sea.hulls(10.0);
  ASSERT_EQ(hulls.size(), 2u);
  EXPECT_EQ(hulls[0].vessel, 0u);
  EXPECT_EQ(hulls[0].hull, 0u);
  // In closed form; the plane's north at its anchor is true.
  EXPECT_NEAR(hulls[0].pose.position.x, 0.0, 1e-9);
  EXPECT_NEAR(hulls[0].pose.position.y, 50.0, 1e-9);
  EXPECT_NEAR(hulls[0].pose.height, 0.0, 1e-12);  // calm water
  EXPECT_EQ(hulls[1].vessel, 1u);
}

// A wave as long as eight hulls: the hull lies on it within a twentieth of its height and slope,
// for its own length smooths both by 1 − (πL/λ)²/6.
TEST(ServedSea, AVesselOnItsCourseLiesOnTheWaterUnderIt) {
  ServedWaters served(test::sceneText(
      {{"jonswap:\n      hm0_m: 1.12\n      tp_s: 5.6\n      from_deg: 196", "calm: {}"},
       {"run:", "effects: {wake: off}\nrun:"}}));
  served.sea.setOctaves({makeRegularWave(1.0, 1.0 / 8.0, 0.0, 0.0)});
  for (const double t : {0.0, 1.0, 2.5, 7.0}) {
    const ServedHull hull = served.sea.hulls(t).at(0);
    const SurfaceSample water = served.sea.surface()->sample(hull.pose.position, t);
    EXPECT_NEAR(hull.pose.height, water.height, 0.05);
    const double along = water.slope.x * std::cos(hull.pose.direction) +
                         water.slope.y * std::sin(hull.pose.direction);
    EXPECT_NEAR(std::tan(hull.pose.pitch), along, 0.05 * 0.063);
  }
}

TEST(ServedSea, AHostsHullTakesThePlaceOfTheScenesAndGivesItBack) {
  ServedWaters served;
  const std::uint32_t hull = served.sea.addHull(0);
  ASSERT_NE(hull, 0u);
  EXPECT_EQ(served.sea.hulls(1.0).at(0).hull, 0u);  // not placed yet
  HostedPose pose = served.poseAt({200.0, -30.0}, 90.0);
  pose.height = 0.4, pose.pitch_deg = 3.0, pose.roll_deg = -5.0;
  EXPECT_TRUE(served.sea.place(hull, 1.0, pose));
  const auto hulls = served.sea.hulls(1.0);
  ASSERT_EQ(hulls.size(), 2u);
  EXPECT_EQ(hulls[0].hull, hull);
  // Geodesy's round trip.
  EXPECT_NEAR(hulls[0].pose.position.x, 200.0, 1e-6);
  EXPECT_NEAR(hulls[0].pose.position.y, -30.0, 1e-6);
  EXPECT_NEAR(std::remainder(hulls[0].pose.direction, 2.0 * pi), 0.0, 1e-6);
  EXPECT_EQ(hulls[0].pose.height, 0.4);
  EXPECT_NEAR(hulls[0].pose.pitch, radiansFromDegrees(3.0), 1e-15);
  EXPECT_NEAR(hulls[0].pose.roll, radiansFromDegrees(-5.0), 1e-15);
  served.sea.removeHull(hull);
  EXPECT_EQ(served.sea.hulls(1.0).at(0).hull, 0u);
  EXPECT_EQ(served.sea.addHull(2), 0u);
  EXPECT_FALSE(served.sea.place(hull, 2.0, pose));
}

TEST(ServedSea, AHullIsBetweenItsPosesGoesOnForHalfASecondAndRests) {
  ServedWaters served;
  const std::uint32_t hull = served.sea.addHull(1);
  for (int i = 0; i <= 10; ++i) {
    served.sea.place(hull, 0.1 * i, served.poseAt({4.0 * 0.1 * i, 0.0}, 90.0));
  }
  const auto eastAt = [&](double t) { return served.sea.hulls(t).at(1).pose.position.x; };
  EXPECT_NEAR(eastAt(0.55), 2.2, 1e-6);
  EXPECT_NEAR(eastAt(1.3), 5.2, 1e-6);
  EXPECT_NEAR(eastAt(1.5), 6.0, 1e-6);
  EXPECT_NEAR(eastAt(100.0), 6.0, 1e-6);
  EXPECT_NEAR(eastAt(-5.0), 0.0, 1e-6);
}

TEST(ServedSeaHard, PosesThatCannotBeChangeNothing) {
  ServedWaters served;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::uint32_t hull = served.sea.addHull(0);
  const HostedPose good = served.poseAt({10.0, 10.0});
  HostedPose lost = good, far = good, tilted = good;
  lost.latitude_deg = nan;
  far.latitude_deg = 45.0;
  tilted.roll_deg = nan;
  EXPECT_FALSE(served.sea.place(hull, 1.0, lost));
  EXPECT_FALSE(served.sea.place(hull, 1.0, far));
  EXPECT_FALSE(served.sea.place(hull, 1.0, tilted));
  EXPECT_FALSE(served.sea.place(hull, nan, good));
  EXPECT_FALSE(served.sea.place(hull, 1e300, good));
  EXPECT_FALSE(served.sea.place(77, 1.0, good));
  EXPECT_EQ(served.sea.hulls(1.0).at(0).hull, 0u);
  EXPECT_TRUE(served.sea.place(hull, 1.0, good));
  EXPECT_FALSE(served.sea.place(hull, 1.0, good));
  EXPECT_FALSE(served.sea.place(hull, 0.5, good));
}

TEST(ServedWakes, AVesselOnItsCourseLeavesTheWakeThatTheSimulationHas) {
  ServedWaters served;
  const Sea sea = buildSea(served.scene);
  Simulation simulation = Simulation::replayed(served.scene, sea, 12.0);
  simulation.attend({.cameras = {}, .places = {{{0.0, 40.0}, 1.0, 0}}});
  served.bringWakes(12.0, {0.0, 40.0});  // and looked at once: what nobody asks for is let go of
  const auto surface = served.sea.surface();
  const auto span = served.sea.wakeSpan();
  ASSERT_TRUE(span);
  EXPECT_LE(span->first, 12.0);
  EXPECT_GE(span->second, 12.0);
  const double highest = largestWave(simulation.surface(), 12.0, 42.0);
  EXPECT_GT(highest, 0.02);
  for (int i = 0; i < 200; ++i) {
    const glm::dvec2 place(-20.0 + 0.2 * i, 42.0);
    // Two ways to have come there agree within 1 % of the wake (WakeSystem).
    EXPECT_NEAR(surface->sample(place, 12.0).height,
                simulation.surface().sample(place, 12.0).height, 0.01 * highest);
  }
}

TEST(ServedWakes, AskersAreToldWhereWakesAreNotThereAndNeverWait) {
  ServedWaters served;
  const WakeListener near{{0.0, 0.0}, 1.0, 0}, far{{5000.0, 0.0}, 1.0, 0};
  EXPECT_EQ(served.sea.attend(3.0, std::span(&far, 1)), SampleStatus::ok);
  EXPECT_FALSE(served.sea.wakeSpan());
  EXPECT_EQ(served.sea.attend(3.0, std::span(&near, 1)), SampleStatus::wakeOutOfTime);
  ASSERT_TRUE(served.sea.awaitWakes(60.0));
  EXPECT_EQ(served.sea.attend(3.0, std::span(&near, 1)), SampleStatus::ok);
  EXPECT_EQ(served.sea.surface()->sample({0.0, 0.0}, 3.0).status, SampleStatus::ok);
  EXPECT_EQ(served.sea.attend(10.0, std::span(&near, 1)), SampleStatus::wakeOutOfTime);
  ASSERT_TRUE(served.sea.awaitWakes(60.0));
  EXPECT_EQ(served.sea.attend(10.0, std::span(&near, 1)), SampleStatus::ok);
  EXPECT_TRUE(
      has(served.sea.surface()->sample({0.0, 0.0}, 3.0).status, SampleStatus::wakeOutOfTime));
}

TEST(ServedWakes, AHostsHullLeavesAWakeThatItDoesNotFeelItself) {
  ServedWaters served(pilotScene("", "0"));
  const std::uint32_t hull = served.sea.addHull(0);
  for (int i = 0; i <= 150; ++i) {
    served.sea.place(hull, 0.1 * i, served.poseAt({0.0, 0.5 * i}));
    if (i % 10 == 0) served.bringWakes(0.1 * i, {0.0, 0.5 * i - 20.0});
  }
  served.bringWakes(15.0, {0.0, 50.0});
  const auto surface = served.sea.surface();
  EXPECT_GT(largestWave(*surface, 15.0, 55.0), 0.02);
  EXPECT_EQ(largestWave(*surface, 15.0, 55.0, {.excludeVessel = served.sea.ownWake(hull)}), 0.0);
}

TEST(ServedWakesHard, TimeMayGoBackAndTheCoursesWakesAreTheSameAgain) {
  ServedWaters served;
  const auto at = [&](double t) {
    served.bringWakes(t, {0.0, 5.0 * t});
    // Whoever asked for a later time is still about for two seconds.
    return served.sea.surface()->sample({3.0, 5.0 * t - 25.0}, t);
  };
  const SurfaceSample first = at(12.0);
  EXPECT_NE(first.height, 0.0);
  EXPECT_EQ(first.status, SampleStatus::ok);
  at(200.0);
  std::this_thread::sleep_for(WakeAttention::patience + std::chrono::milliseconds(300));
  const SurfaceSample again = at(12.0);
  EXPECT_EQ(again.status, SampleStatus::ok);
  EXPECT_NEAR(again.height, first.height, 1e-3);
}

TEST(ServedWakesHard, AHostThatBeginsAgainLeavesAWakeAgain) {
  ServedWaters served(pilotScene("", "0"));
  const std::uint32_t hull = served.sea.addHull(0);
  for (const double start : {1000.0, 0.0}) {
    for (int i = 0; i <= 120; ++i) {
      EXPECT_TRUE(served.sea.place(hull, start + 0.1 * i, served.poseAt({0.0, 0.5 * i})));
      if (i % 10 == 0) served.bringWakes(start + 0.1 * i, {0.0, 0.5 * i - 20.0});
    }
    served.bringWakes(start + 12.0, {0.0, 40.0});
    EXPECT_GT(largestWave(*served.sea.surface(), start + 12.0, 42.0), 0.02) << start;
    std::this_thread::sleep_for(WakeAttention::patience + std::chrono::milliseconds(300));
  }
}

// The later clock has the wakes; the other is answered and told so.
TEST(ServedWakesHard, TwoHostsWithClocksApartAreBothAnswered) {
  ServedWaters served;
  const WakeListener early{{0.0, 0.0}, 1.0, 0}, late{{0.0, 500.0}, 1.0, 0};
  served.bringWakes(100.0, late.position);
  for (int i = 0; i < 20; ++i) {
    EXPECT_EQ(served.sea.attend(1.0, std::span(&early, 1)), SampleStatus::wakeOutOfTime);
    ASSERT_TRUE(served.sea.awaitWakes(60.0));
    EXPECT_EQ(served.sea.attend(100.0, std::span(&late, 1)), SampleStatus::ok);
    EXPECT_TRUE(std::isfinite(served.sea.surface()->sample({0.0, 0.0}, 1.0).height));
  }
}

// As `seaway query` asks it.
TEST(ServedDetail, WhatRipplesTheWaterIsThatOfTheTimeAskedFor) {
  ServedWaters served(pilotScene(test::oilAndRipples));
  const Sea sea = buildSea(served.scene);
  SceneDetail detail(served.scene, sea);
  for (const double t : {3.0, 6.0, 6.02}) {
    served.bringWakes(t, {44.5, 44.2});
    detail.advance(t);
    WaterSurface expected = sea.surface;
    expected.setDetail(detail.detail());
    double largest = 0.0;
    for (int i = 0; i < 100; ++i) {
      const glm::dvec2 point(35.0 + 0.2 * i, 44.0);
      const double height = served.sea.surface()->sample(point, t).height;
      EXPECT_EQ(height, expected.sample(point, t).height) << t << " " << i;
      largest = std::max(largest, std::abs(height));
    }
    EXPECT_GT(largest, 1e-4);
  }
}

TEST(ServedDetail, AskersOfAnotherTimeAreToldAndNeverWait) {
  ServedWaters served(pilotScene(test::oilAndRipples));
  const WakeListener listener{{44.0, 44.0}, 1.0, 0};
  const auto ask = [&](double t) { return served.sea.attend(t, std::span(&listener, 1)); };
  EXPECT_EQ(ask(6.0), SampleStatus::wakeOutOfTime);
  EXPECT_TRUE(served.sea.awaitWakes(60.0));
  EXPECT_EQ(ask(6.0), SampleStatus::ok);
  EXPECT_EQ(ask(2.0), SampleStatus::wakeOutOfTime);  // of a clock behind
  EXPECT_EQ(ask(6.3), SampleStatus::ok);             // on its way
}

TEST(ServedDetail, AVesselThatAHostSailsLeavesNoTrailOnItsCourse) {
  ServedWaters served(pilotScene("effects: {wake: off}\n"));
  const auto foam = [&](double t) {
    served.bringWakes(t, {0.0, 0.0});
    const auto lies = served.sea.surface()->extras().detail;
    return lies && lies->cover.foam ? lies->cover.foam->cellCount() : std::size_t{0};
  };
  EXPECT_GT(foam(4.0), 0u);
  ServedWaters sailed(pilotScene("effects: {wake: off}\n"));
  sailed.sea.place(sailed.sea.addHull(0), 0.0, sailed.poseAt({300.0, 0.0}));
  sailed.bringWakes(4.0, {0.0, 0.0});
  EXPECT_EQ(sailed.sea.surface()->extras().detail, nullptr);
}

TEST(ServedSea, AReloadedSceneKeepsHullsWhoseVesselIsThereStill) {
  ServedWaters served;
  const std::uint32_t pilot = served.sea.addHull(0), buoy = served.sea.addHull(1);
  served.sea.place(pilot, 1.0, served.poseAt({50.0, 0.0}));
  served.sea.place(buoy, 1.0, served.poseAt({80.0, 0.0}));
  const Scene next = test::loadText(
      "sea: {anchor: {latitude_deg: 0, longitude_deg: 0}, state: {calm: {}}}\n"
      "vessels:\n"
      "  - {name: tug, model: launch.yaml, start: {latitude_deg: 0.001, longitude_deg: 0}}\n"
      "  - {name: buoy, model: launch.yaml, start: {latitude_deg: 0, longitude_deg: 0}}\n"
      "run: {step_s: 0.05}\n");
  served.sea.replaceScene(next, buildSea(next));
  const auto hulls = served.sea.hulls(1.0);
  ASSERT_EQ(hulls.size(), 2u);
  EXPECT_EQ(hulls[0].hull, 0u);
  EXPECT_EQ(hulls[1].hull, buoy);
  EXPECT_NEAR(hulls[1].pose.position.x, 80.0, 1e-6);
  EXPECT_FALSE(served.sea.place(pilot, 2.0, served.poseAt({50.0, 0.0})));
  EXPECT_TRUE(served.sea.place(buoy, 2.0, served.poseAt({81.0, 0.0})));
  EXPECT_EQ(served.sea.scene()->vessels[0].name, "tug");
}

TEST(ServedSeaHard, ASceneWithAnotherAnchorIsRefusedAndTheOldOneServed) {
  ServedWaters served;
  const Scene next = test::loadText(
      "sea: {anchor: {latitude_deg: 1, longitude_deg: 0}, state: {calm: {}}}\nrun: {}\n");
  EXPECT_NE(
      test::inputErrorOf([&] { served.sea.replaceScene(next, buildSea(next)); }).find("sea.anchor"),
      std::string::npos);
  EXPECT_EQ(served.sea.scene()->vessels.size(), 2u);
}

// Everybody at once, for the thread sanitizer.
TEST(ServedSeaHard, HostsQueriesWavesAndReloadsGoOnAtOnce) {
  ServedWaters served;
  std::atomic<bool> ending = false;
  std::vector<std::thread> threads;
  for (int host = 0; host < 3; ++host) {
    threads.emplace_back([&, host] {
      for (int i = 0; !ending; ++i) {
        const std::uint32_t hull = served.sea.addHull(static_cast<std::size_t>(host) % 2);
        for (int k = 0; k < 20; ++k) {
          const double t = 0.05 * (20 * i + k);
          served.sea.place(hull, t, served.poseAt({10.0 * host, 3.0 * t}));
          const WakeListener here{{10.0 * host, 3.0 * t}, 5.0, served.sea.ownWake(hull)};
          served.sea.attend(t, std::span(&here, 1));
          EXPECT_TRUE(std::isfinite(served.sea.surface()->sample(here.position, t).height));
          served.sea.hulls(t);
        }
        served.sea.removeHull(hull);
      }
    });
  }
  threads.emplace_back([&] {
    while (!ending) {
      served.sea.setOctaves({makeRegularWave(0.1, 0.2, 0.0, 0.0)});
      served.sea.restoreOctaves();
    }
  });
  const Scene other = test::loadText(pilotScene("", "3"));
  for (int i = 0; i < 10; ++i) {
    served.sea.replaceScene(other, buildSea(other));
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
  }
  ending = true;
  for (std::thread& thread : threads) thread.join();
}

}  // namespace
}  // namespace seaway::bridge
