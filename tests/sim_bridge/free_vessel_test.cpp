#include "sim_bridge/vessel/free_vessel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "sim_bridge/scene/scene_loader.h"
#include "sim_bridge/scene/vessel_launch.h"
#include "sim_bridge/scene_view.h"
#include "sim_bridge/simulation.h"
#include "surface/angles.h"
#include "surface/input_error.h"
#include "tests/sim_bridge/driven_vessel.h"
#include "tests/sim_bridge/test_support.h"

namespace seaway::bridge {
namespace {

/// A free launch, from the anchor northwards to a waypoint and then east; others as given. 0.0001°
/// are 11.1 m.
std::string sceneOf(const std::string& others = "", const std::string& more = "",
                    const std::string& state = "{calm: {}}", const std::string& sea = "") {
  return "sea: {anchor: {latitude_deg: 0, longitude_deg: 0}, state: " + state + sea + "}\n" +
         "vessels:\n"
         "  - {name: pilot, model: driven.yaml, motion: free, start: {latitude_deg: 0, "
         "longitude_deg: 0, heading_deg: 0}, speed_m_s: 4, waypoints: [{latitude_deg: 0.0006, "
         "longitude_deg: 0}, {latitude_deg: 0.0006, longitude_deg: 0.01}]}\n" +
         others +
         "cameras:\n  - {name: bow, mount: pilot, position_m: [3, 0, 3]}\n"
         "accuracy: {wakes: {cell_m: 1, window_m: 128}}\n" +
         more + "run: {step_s: 0.05, size: [64, 48]}\n";
}

const std::string rough = "{jonswap: {hm0_m: 0.5, tp_s: 4, from_deg: 30, spread_s: 10}}";
const std::string anchored =
    "  - {name: anchored, model: launch.yaml, start: {latitude_deg: 0.00032, longitude_deg: "
    "0.00015}}\n";
const std::string passing =
    "  - {name: passing, model: launch.yaml, speed_m_s: 6, start: {latitude_deg: -0.0006, "
    "longitude_deg: 0.0002, heading_deg: 0}}\n";

struct Waters {
  explicit Waters(const std::string& text, const std::string& vessel = test::drivenVessel) {
    const test::TempFolder folder;
    folder.write("driven.yaml", vessel);
    folder.write("launch.yaml", test::vesselText());
    scene = loadScene(folder.write("scene.yaml", text));
    sea.emplace(buildSea(scene));
  }
  Simulation start() const { return Simulation(scene, *sea); }
  Scene scene;
  std::optional<Sea> sea;
};

void expectSameBits(const VesselPose& a, const VesselPose& b) {
  EXPECT_EQ(a.position, b.position);
  EXPECT_EQ(a.height, b.height);
  EXPECT_EQ(a.direction, b.direction);
  EXPECT_EQ(a.roll, b.roll);
  EXPECT_EQ(a.pitch, b.pitch);
}

EffectReport reportOf(const EffectLedger& ledger, Effect effect) {
  return ledger.report()[static_cast<std::size_t>(effect)];
}

TEST(FreeVessels, SteerAlongTheirWaypointsUnderTheirOwnPower) {
  const Waters waters(sceneOf("", "", rough));
  Simulation simulation = waters.start();
  simulation.stepTo(60.0);
  const VesselPose pose = simulation.vessels()[0].pose();
  // 67 m north, then east: round the corner by then.
  EXPECT_NEAR(pose.position.y, 66.0, 15.0);
  EXPECT_GT(pose.position.x, 60.0);
  EXPECT_NEAR(simulation.vessels()[0].speed(), 4.0, 0.8);
  EXPECT_LT(std::abs(pose.height - simulation.vessels()[0].waterHeight()), 0.5);
}

TEST(FreeVessels, ReplaysAndCopiesGiveTheSameBits) {
  const Waters waters(sceneOf(passing, "", rough));
  Simulation stepped = waters.start(), watched = waters.start();
  for (int i = 0; i < 60; ++i) {
    stepped.step();
    watched.step();
    if (i % 10 != 0) continue;
    const Simulation moment = watched.movedTo(watched.time() + 0.013);
    EXPECT_NEAR(moment.time(), watched.time() + 0.013, 1e-12);
  }
  const Simulation replayed = Simulation::replayed(waters.scene, *waters.sea, stepped.time());
  for (std::size_t i = 0; i < 2; ++i) {
    expectSameBits(stepped.vessels()[i].pose(), replayed.vessels()[i].pose());
    expectSameBits(stepped.vessels()[i].pose(), watched.vessels()[i].pose());
  }
  expectSameBits(stepped.movedTo(3.53).vessels()[0].pose(),
                 Simulation::replayed(waters.scene, *waters.sea, 3.53).vessels()[0].pose());
}

TEST(FreeVessels, AloneMoveAsSeawaySailHasThem) {
  const Waters waters(sceneOf("", "effects: {wake: off, trail: off}\n", rough));
  Simulation simulation = waters.start();
  FreeVessel vessel = launchFree(waters.scene, waters.scene.vessels[0], *waters.sea);
  vessel.settle(waters.sea->surface, 0);
  for (int i = 1; i <= 100; ++i) {
    simulation.step();
    vessel.advance(i * 0.05, waters.sea->surface, 0);
  }
  expectSameBits(simulation.vessels()[0].pose(), vessel.pose());
}

TEST(FreeVessels, LieOnTheWaterAtTheirStart) {
  const Waters waters(sceneOf("", "", rough));
  const Simulation simulation = waters.start();
  const Vessel& vessel = simulation.vessels()[0];
  EXPECT_NEAR(vessel.pose().height, vessel.waterHeight(), 0.15);
  EXPECT_NEAR(glm::length(vessel.pose().position), 0.0, 1e-9);
}

TEST(FreeVessels, RockOthersAndAreRockedButNotByTheirOwnWake) {
  const auto largestRoll = [](const Waters& waters, std::size_t vessel) {
    Simulation simulation = waters.start();
    double largest = 0.0;
    while (simulation.time() < 16.0) {
      simulation.step();
      largest = std::max(largest, std::abs(simulation.vessels()[vessel].pose().roll));
    }
    return degreesFromRadians(largest);
  };
  // Straight on: the rudder heels nobody.
  const auto straight = [](const std::string& others, const std::string& more = "") {
    std::string text = sceneOf(others, more);
    return Waters(text.replace(text.find("latitude_deg: 0.0006"), 20, "latitude_deg: 0.0060"));
  };
  const std::string quiet = "effects: {wake: off}\n";
  // The free pilot passes an anchored launch.
  EXPECT_GT(largestRoll(straight(anchored), 1), 0.05);
  EXPECT_NEAR(largestRoll(straight(anchored, quiet), 1), 0.0, 1e-9);
  // A launch overtakes the free pilot, which its own wake does not heel.
  EXPECT_GT(largestRoll(straight(passing), 0), 0.05);
  EXPECT_LT(largestRoll(straight(anchored), 0), 0.01);
}

TEST(FreeVessels, LeaveWakeAndTrailWhereTheyHaveBeen) {
  const Waters waters(sceneOf());
  Simulation simulation = waters.start();
  simulation.attend({.cameras = waters.scene.cameras, .places = {}});
  simulation.stepTo(35.0);
  const Vessel& vessel = simulation.vessels()[0];
  const CoursePoint before = vessel.placeAt(30.0);
  // Round the corner: the straight course of its start would be 140 m north.
  EXPECT_GT(vessel.pose().position.x, 10.0);
  EXPECT_LT(glm::distance(before.position, vessel.pose().position), 25.0);
  const SurfaceExtras& extras = simulation.surface().extras();
  ASSERT_TRUE(extras.detail && extras.detail->cover.foam);
  float astern = 0.0f, ahead = 0.0f;
  for (double y = -2.0; y <= 2.0; y += 0.25) {
    const glm::dvec2 aside =
        y * glm::dvec2(-std::sin(before.direction), std::cos(before.direction));
    astern = std::max(astern, extras.detail->cover.foam->coverAt(before.position + aside, 35.0));
    ahead = std::max(ahead, extras.detail->cover.foam->coverAt(glm::dvec2(y, 140.0), 35.0));
  }
  EXPECT_GT(astern, 0.1f);
  EXPECT_EQ(ahead, 0.0f);
  double highest = 0.0;
  for (double along = 5.0; along < 30.0; along += 0.5) {
    const CoursePoint past = vessel.placeAt(35.0 - along / 4.0);
    highest = std::max(highest, std::abs(simulation.surface().sample(past.position, 35.0).height));
  }
  EXPECT_GT(highest, 0.03);
}

TEST(FreeVessels, HaveSailedStraightToTheirStart) {
  const Waters waters(sceneOf());
  const Simulation simulation = waters.start();
  const CoursePoint past = simulation.vessels()[0].placeAt(-10.0);
  EXPECT_NEAR(past.position.x, 0.0, 1e-6);
  EXPECT_NEAR(past.position.y, -40.0, 1e-6);
  const SurfaceExtras& extras = simulation.surface().extras();
  ASSERT_TRUE(extras.detail && extras.detail->cover.foam);
}

TEST(FreeVessels, CarryCamerasAndAreDrawnWhereTheyLie) {
  const Waters waters(sceneOf("", "", rough));
  Simulation simulation = waters.start();
  simulation.stepTo(3.0);
  SceneView view(waters.scene);
  EffectLedger ledger(waters.scene.effects);
  const render::View seen = view.view(simulation, waters.scene.cameras[0], {64, 48}, ledger);
  const VesselPose pose = simulation.vessels()[0].pose();
  const glm::dvec3 place =
      glm::dvec3(pose.position, pose.height) + pose.worldFromBody() * glm::dvec3(3.0, 0.0, 3.0);
  EXPECT_NEAR(glm::distance(seen.camera.position, place), 0.0, 1e-9);
  ASSERT_EQ(seen.objects.size(), 1u);
  EXPECT_EQ(seen.objects[0].position, glm::dvec3(pose.position, pose.height));
}

TEST(FreeVessels, ChargeHullLoadsAndNobodyElseDoes) {
  const Waters waters(sceneOf());
  EffectLedger ledger(waters.scene.effects);
  Simulation simulation = waters.start();
  simulation.step(&ledger);
  const EffectReport report = reportOf(ledger, Effect::hullLoads);
  EXPECT_EQ(report.state, EffectState::on);
  EXPECT_EQ(report.reason, "a vessel's motion is free");
  EXPECT_GT(report.memoryBytes, 10000u);
  EXPECT_GT(report.costMicroseconds, 0.0);
  EXPECT_EQ(reportOf(ledger, Effect::vesselMotion).state, EffectState::idle);
  std::string text = sceneOf();
  text.replace(text.find("motion: free"), 12, "motion: prescribed");
  const Waters bound(text);
  EffectLedger idle(bound.scene.effects);
  Simulation plain = bound.start();
  plain.step(&idle);
  EXPECT_EQ(reportOf(idle, Effect::hullLoads).state, EffectState::idle);
  EXPECT_EQ(reportOf(idle, Effect::hullLoads).memoryBytes, 0u);
  EXPECT_EQ(reportOf(idle, Effect::hullLoads).costMicroseconds, 0.0);
  EXPECT_EQ(bound.scene.vessels[0].mesh, nullptr);
  EXPECT_EQ(plain.vessels()[0].free(), nullptr);
}

TEST(FreeVessels, KeepTheirCourseWhereLoadsAreOff) {
  const Waters waters(sceneOf("", "effects: {hull_loads: off}\n"));
  Simulation simulation = waters.start();
  simulation.stepTo(5.0);
  EXPECT_NEAR(simulation.vessels()[0].pose().position.y, 20.0, 1e-6);
  EXPECT_NE(simulation.vessels()[0].prescribed(), nullptr);
}

TEST(FreeVessels, AreDrivenByTheWindWhereItHasADirection) {
  std::string text = sceneOf("", "light: {wind: {speed_m_s: 15, from_deg: 270}}\n");
  text.replace(text.find("speed_m_s: 4, waypoints"), 12, "speed_m_s: 0");
  const auto eastAfter = [](const std::string& scene) {
    Waters waters(scene, test::drivenVessel.substr(0, test::drivenVessel.find("propeller")));
    Simulation simulation = waters.start();
    simulation.stepTo(20.0);
    return simulation.vessels()[0].pose().position.x;
  };
  const auto adrift = [](std::string scene) {
    const std::size_t from = scene.find(", waypoints"), to = scene.find("]", from) + 1;
    return scene.erase(from, to - from);
  };
  EXPECT_GT(eastAfter(adrift(text)), 1.0);
  text.replace(text.find(", from_deg: 270"), 15, "");
  EXPECT_NEAR(eastAfter(adrift(text)), 0.0, 1e-3);
}

TEST(FreeVesselsHard, ShoresAndBedsAreTold) {
  const Waters shallow(sceneOf("", "", "{calm: {}}", ", depth_m: 0.7"));
  Simulation simulation = shallow.start();
  const std::string bed = test::inputErrorOf([&] { simulation.stepTo(5.0); });
  EXPECT_NE(bed.find("'pilot' touches the bed"), std::string::npos) << bed;
  test::TempFolder folder;
  folder.write("driven.yaml", test::drivenVessel);
  folder.write("lake.geojson",
               R"({"type": "Polygon", "coordinates": [[[-0.01, -0.01], [0.01, -0.01],
               [0.01, 0.0002], [-0.01, 0.0002], [-0.01, -0.01]]]})");
  const Scene scene = loadScene(
      folder.write("scene.yaml", sceneOf("", "", "{calm: {}}", ", outline: lake.geojson")));
  const Sea sea = buildSea(scene);
  Simulation ashore(scene, sea);
  const std::string shore = test::inputErrorOf([&] { ashore.stepTo(20.0); });
  EXPECT_NE(shore.find("'pilot' is aground"), std::string::npos) << shore;
}

TEST(FreeVesselsHard, OneThatSailsOntoATerrainIsTold) {
  // A bed 5 m deep that rises northwards from 20 m on: by 1 in 4 to a beach, or as a wall.
  const auto fault = [](double steepness) {
    Waters waters(sceneOf());
    TerrainMap::Grid grid{{-100.0, -100.0}, {2.0, 2.0}, {101, 101}, {}};
    for (int row = 0; row < 101; ++row) {
      const double north = -100.0 + 2.0 * row;
      const double height = std::min(-5.0 + steepness * std::max(north - 20.0, 0.0), 3.0);
      grid.heights.insert(grid.heights.end(), 101, static_cast<float>(height));
    }
    waters.scene.terrain.map = std::make_shared<const TerrainMap>(grid);
    waters.sea->surface.setTerrain(waters.scene.terrain.map);
    Simulation simulation = waters.start();
    const std::string message = test::inputErrorOf([&] { simulation.stepTo(30.0); });
    // At 4 m/s, its bow 6 m ahead: not before the bed rises.
    EXPECT_GT(simulation.time(), 2.5);
    EXPECT_LT(simulation.time(), 12.0);
    return message;
  };
  for (const double steepness : {0.25, 4.0}) {
    const std::string message = fault(steepness);
    EXPECT_NE(message.find("'pilot' is aground at "), std::string::npos) << message;
    EXPECT_NE(message.find("below the terrain"), std::string::npos) << message;
  }
}

TEST(FreeVesselsHard, WhatCannotMoveFreelyIsRefusedWithItsLine) {
  const auto fault = [](std::string text, const std::string& vessel) {
    return test::inputErrorOf([&] { Waters waters(text, vessel); });
  };
  std::string turning = sceneOf();
  turning.replace(turning.find("speed_m_s: 4"), 12, "speed_m_s: 4, turn_deg_s: 1");
  EXPECT_NE(fault(turning, test::drivenVessel).find("prescribed motion only"), std::string::npos);
  const std::string still =
      fault(sceneOf(), test::drivenVessel.substr(0, test::drivenVessel.find("propeller")));
  EXPECT_NE(still.find("no propeller and rudder"), std::string::npos) << still;
  std::string missing = test::drivenVessel;
  missing.replace(missing.find("wigley:12,3,0.8,1"), 17, "missing.stl");
  const std::string mesh = fault(sceneOf(), missing);
  EXPECT_NE(mesh.find("missing.stl"), std::string::npos) << mesh;
  EXPECT_NE(mesh.find("scene.yaml"), std::string::npos) << mesh;
}

TEST(FreeVesselsHard, LongStepsOfTheSceneAreDividedAndStayFinite) {
  std::string text = sceneOf(anchored, "", rough);
  text.replace(text.find("step_s: 0.05"), 12, "step_s: 1.0");
  const Waters waters(text);
  Simulation simulation = waters.start();
  simulation.stepTo(30.0);
  const VesselPose pose = simulation.vessels()[0].pose();
  EXPECT_TRUE(std::isfinite(pose.height + pose.roll + pose.pitch));
  EXPECT_NEAR(simulation.vessels()[0].speed(), 4.0, 1.0);
}

TEST(VesselPoses, OfQuaternionsAreTheirAngles) {
  for (const double pitch : {-0.5 * pi, -1.2, 0.0, 0.7, 0.5 * pi}) {
    for (const double roll : {-3.0, -0.4, 0.0, 1.5, 3.1}) {
      const VesselPose pose{{1.0, 2.0}, 0.8, 3.0, pitch, roll};
      const VesselPose back = vesselPose({1.0, 2.0, 3.0}, pose.worldFromBody());
      // With the bow upright heading and roll turn about one axis: the attitude counts.
      EXPECT_NEAR(std::abs(glm::dot(back.worldFromBody(), pose.worldFromBody())), 1.0, 1e-12);
      if (std::abs(pitch) < 1.5) {
        EXPECT_NEAR(back.roll, roll, 1e-9);
        EXPECT_NEAR(back.direction, 0.8, 1e-9);
      }
    }
  }
}

TEST(VesselTracks, InterpolateBetweenWhatWasNoted) {
  VesselTrack track(Course({0.0, 0.0}, 0.0, 2.0, 0.0));
  for (int i = 0; i <= 500; ++i) {
    const double t = 0.02 * i;
    track.record(t, {{2.0 * t, 0.5 * t * t}, std::atan2(t, 2.0), {2.0, t}});
  }
  EXPECT_LT(track.memoryBytes(), 110u * 64u);
  for (const double t : {0.013, 3.377, 9.99}) {
    EXPECT_NEAR(track.at(t).position.x, 2.0 * t, 1e-9);
    EXPECT_NEAR(track.at(t).position.y, 0.5 * t * t, 1e-9);
    EXPECT_NEAR(track.at(t).direction, std::atan2(t, 2.0), 1e-3);
  }
  EXPECT_EQ(track.at(-3.0).position.x, -6.0);
}

}  // namespace
}  // namespace seaway::bridge
