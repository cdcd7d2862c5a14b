#include "sim_bridge/scene_wakes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "sim_bridge/scene/scene_loader.h"
#include "sim_bridge/simulation.h"
#include "surface/angles.h"
#include "tests/sim_bridge/test_support.h"

namespace seaway::bridge {
namespace {

/// A launch under way, northwards along x = 0, in calm water; others as given. Windows of 128 m in
/// cells of 1 m: waves of 4 m and more, which are those that move hulls.
std::string sceneOf(const std::string& others, const std::string& more = "") {
  return "sea: {anchor: {latitude_deg: 0, longitude_deg: 0}, state: {calm: {}}}\n"
         "vessels:\n"
         "  - {name: pilot, model: launch.yaml, start: {latitude_deg: 0, longitude_deg: 0, "
         "heading_deg: 0}, speed_m_s: 5}\n" +
         others +
         "cameras:\n  - {name: bow, mount: pilot}\n"
         "accuracy: {wakes: {cell_m: 1, window_m: 128}}\n" +
         more + "run: {step_s: 0.05}\n";
}

// 0.0001° are 11.1 m: abeam of the pilot's track, 35 m ahead of its start.
const std::string anchored =
    "  - {name: anchored, model: launch.yaml, start: {latitude_deg: 0.00032, longitude_deg: "
    "0.00015}}\n";
const std::string faraway =
    "  - {name: faraway, model: launch.yaml, start: {latitude_deg: 0.05, longitude_deg: 0}}\n";

struct Waters {
  explicit Waters(const std::string& text, const std::string& vessel = test::vesselText()) {
    const test::TempFolder folder;
    folder.write("launch.yaml", vessel);
    scene = loadScene(folder.write("scene.yaml", text));
    sea.emplace(buildSea(scene));
  }
  Simulation start() const { return Simulation(scene, *sea); }
  Scene scene;
  std::optional<Sea> sea;
};

double largestRoll(Simulation simulation, std::size_t vessel, double until) {
  double largest = 0.0;
  while (simulation.time() < until) {
    simulation.step();
    largest = std::max(largest, std::abs(simulation.vessels()[vessel].pose().roll));
  }
  return largest;
}

std::vector<glm::dvec2> astern(double y) {
  std::vector<glm::dvec2> points;
  for (int i = 0; i < 200; ++i) points.emplace_back(-20.0 + 0.2 * i, y);
  return points;
}

double largestHeight(const WaterSurface& surface, double t, const std::vector<glm::dvec2>& points) {
  double largest = 0.0;
  for (const glm::dvec2 point : points) {
    largest = std::max(largest, std::abs(surface.sample(point, t).height));
  }
  return largest;
}

const EffectReport reportOf(const EffectLedger& ledger) {
  return ledger.report()[static_cast<std::size_t>(Effect::wake)];
}

TEST(SceneWakes, RockTheVesselThatIsPassed) {
  const Waters waters(sceneOf(anchored));
  EXPECT_GT(degreesFromRadians(largestRoll(waters.start(), 1, 14.0)), 0.4);
  const Waters without(sceneOf(anchored, "effects: {wake: off}\n"));
  EXPECT_NEAR(largestRoll(without.start(), 1, 14.0), 0.0, 1e-12);
}

TEST(SceneWakes, DoNotMoveTheirOwnVesselUnlessAsked) {
  const Waters waters(sceneOf(anchored));
  Simulation simulation = waters.start();
  simulation.stepTo(5.0);
  EXPECT_NEAR(simulation.vessels()[0].waterHeight(), 0.0, 1e-12);
  EXPECT_NEAR(simulation.vessels()[0].pose().pitch, 0.0, 1e-9);
  const Waters feeling(sceneOf(anchored), test::vesselText() + "wake: {felt_by_itself: true}\n");
  Simulation felt = feeling.start();
  felt.stepTo(5.0);
  EXPECT_GT(std::abs(felt.vessels()[0].pose().pitch), 1e-3);
}

TEST(SceneWakes, AreWholeFromTheStart) {
  const Waters waters(sceneOf(""));
  Simulation simulation = waters.start();
  simulation.attend({.cameras = waters.scene.cameras, .places = {}});
  const double atOnce = largestHeight(simulation.surface(), 0.0, astern(-30.0));
  simulation.stepTo(12.0);
  const double later = largestHeight(simulation.surface(), 12.0, astern(30.0));
  EXPECT_GT(atOnce, 0.1);
  // A steady wake: the same but for cells and steps that fall elsewhere.
  EXPECT_NEAR(later, atOnce, 0.02 * atOnce);
}

TEST(SceneWakes, CostNothingWhereNobodyElseIs) {
  const Waters alone(sceneOf("", "effects: {trail: off}\n"));
  EffectLedger ledger(alone.scene.effects);
  Simulation simulation = alone.start();
  simulation.step(&ledger);
  EXPECT_EQ(simulation.surface().disturbances(), nullptr);
  EXPECT_EQ(&simulation.surface(), &alone.sea->surface);
  EXPECT_EQ(reportOf(ledger).state, EffectState::idle);
  EXPECT_EQ(reportOf(ledger).memoryBytes, 0u);
  EXPECT_EQ(reportOf(ledger).reason, "nobody else is there");
}

TEST(SceneWakes, RunNoWindowForWhoeverIsFarAway) {
  const Waters waters(sceneOf(faraway));
  EffectLedger ledger(waters.scene.effects);
  Simulation simulation = waters.start();
  simulation.step(&ledger);
  EXPECT_EQ(simulation.surface().disturbances(), nullptr);
  EXPECT_EQ(reportOf(ledger).state, EffectState::idle);
  // A place of a query nearby calls for it, `on` does without.
  simulation.attend({.cameras = {}, .places = {{{10.0, -20.0}, 0.0, 0}}});
  EXPECT_NE(simulation.surface().disturbances(), nullptr);
  simulation.attend({});
  const Waters always(sceneOf(faraway, "effects: {wake: on}\n"));
  EXPECT_NE(always.start().surface().disturbances(), nullptr);
}

TEST(SceneWakes, RunNoneWhereNobodyIsUnderWay) {
  const Waters waters(
      "sea: {anchor: {latitude_deg: 0, longitude_deg: 0}, state: {calm: {}}}\n"
      "vessels:\n" +
      anchored + faraway);
  EffectLedger ledger(waters.scene.effects);
  Simulation simulation = waters.start();
  simulation.step(&ledger);
  EXPECT_EQ(reportOf(ledger).reason, "no vessel is under way");
  EXPECT_EQ(&simulation.surface(), &waters.sea->surface);
}

TEST(SceneWakes, ReplayGivesTheBitsOfTheRun) {
  const Waters waters(sceneOf(anchored));
  Simulation stepped = waters.start();
  stepped.stepTo(9.0);
  const Simulation replayed = Simulation::replayed(waters.scene, *waters.sea, 9.0);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(stepped.vessels()[i].pose().roll, replayed.vessels()[i].pose().roll);
    EXPECT_EQ(stepped.vessels()[i].pose().height, replayed.vessels()[i].pose().height);
  }
  for (const glm::dvec2 point : astern(20.0)) {
    EXPECT_EQ(stepped.surface().sample(point, 9.0).height,
              replayed.surface().sample(point, 9.0).height);
  }
}

TEST(SceneWakes, CopyThatMovesOnLeavesTheOriginalAlone) {
  const Waters waters(sceneOf(anchored));
  Simulation watched = waters.start(), alone = waters.start();
  for (int i = 0; i < 12; ++i) {
    const double t = watched.time() + 0.12;
    const Simulation moment = watched.movedTo(t);
    EXPECT_TRUE(moment.surface().disturbances()->end() >= t - 1e-9);
    watched.step();
    alone.step();
    for (const glm::dvec2 point : {glm::dvec2(3.0, -10.0), glm::dvec2(-6.0, -25.0)}) {
      EXPECT_EQ(watched.surface().sample(point, watched.time()).height,
                alone.surface().sample(point, alone.time()).height);
    }
  }
}

TEST(SceneWakes, RebuiltForALateListenerAreThoseThatRanAllAlong) {
  // In 256 m: the border of 128 m is passed by waves of 16 m too soon.
  std::string text = sceneOf("");
  text.replace(text.find("window_m: 128"), 13, "window_m: 256");
  const Waters waters(text);
  const Audience audience{.cameras = waters.scene.cameras, .places = {}};
  Simulation early = waters.start(), late = waters.start();
  early.attend(audience);
  early.stepTo(10.0);
  late.stepTo(10.0);
  late.attend(audience);
  const std::vector<glm::dvec2> points = astern(20.0);
  const double largest = largestHeight(early.surface(), 10.0, points);
  for (const glm::dvec2 point : points) {
    EXPECT_NEAR(early.surface().sample(point, 10.0).height,
                late.surface().sample(point, 10.0).height, 0.01 * largest);
  }
}

TEST(SceneWakes, ReachQueriesNearAVesselUnderWay) {
  const test::TempFolder folder;
  folder.write("launch.yaml", test::vesselText());
  const std::string scene = folder.write("scene.yaml", sceneOf("")).string();
  const auto heightAt = [&](const std::string& time, const std::string& place) {
    const test::Outcome outcome =
        test::seaway({"query", scene, "--time=" + time, "--at", place, "--json"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return nlohmann::json::parse(outcome.out)["points"][0]["height_m"].get<double>();
  };
  // 22 m astern, off the track by 6 m.
  const Waters waters(sceneOf(""));
  Simulation simulation = Simulation::replayed(waters.scene, *waters.sea, 8.0);
  const glm::dvec2 place = waters.sea->geodesy.seaPlaneFromGeodetic(0.00016, 0.00005).position;
  simulation.attend({.cameras = {}, .places = {{place, 0.0, 0}}});
  const double expected = simulation.surface().sample(place, 8.0).height;
  EXPECT_GT(std::abs(expected), 0.01);
  EXPECT_EQ(heightAt("8", "0.00016,0.00005"), expected);
  EXPECT_EQ(heightAt("8", "0.1,0.00005"), 0.0);
  EXPECT_EQ(heightAt("-8", "0.00016,0.00005"), 0.0);  // no vessels before the epoch
}

TEST(SceneWakesHard, TwoHundredVesselsRunNoMoreWakesThanAllowed) {
  std::string others;
  for (int i = 0; i < 199; ++i) {
    others += "  - {name: v" + std::to_string(i) +
              ", model: launch.yaml, start: {latitude_deg: " + std::to_string(0.0004 * (i / 15)) +
              ", longitude_deg: " + std::to_string(0.0004 * (i % 15 + 1)) +
              "}, speed_m_s: " + std::to_string(i % 5) + "}\n";
  }
  std::string text = sceneOf(others);
  text.replace(text.find("window_m: 128"), 13, "window_m: 64, most: 5");
  const Waters waters(text);
  Simulation simulation = waters.start();
  EffectLedger ledger(waters.scene.effects);
  for (int i = 0; i < 10; ++i) simulation.step(&ledger);
  EXPECT_EQ(simulation.surface().disturbances()->wakes().size(), 5u);
  EXPECT_NE(reportOf(ledger).reason.find("the nearest 5 run"), std::string::npos);
  for (const Vessel& vessel : simulation.vessels()) {
    EXPECT_TRUE(std::isfinite(vessel.pose().roll));
  }
}

TEST(SceneWakesHard, HullsThatCrossAndTouchStayFinite) {
  // Straight through the other: nothing keeps prescribed courses apart.
  const Waters waters(
      sceneOf("  - {name: other, model: launch.yaml, start: {latitude_deg: 0.00018, longitude_deg: "
              "0.00018, heading_deg: 270}, speed_m_s: 5}\n"));
  Simulation simulation = waters.start();
  double largest = 0.0;
  while (simulation.time() < 8.0) {
    simulation.step();
    for (const Vessel& vessel : simulation.vessels()) {
      ASSERT_TRUE(std::isfinite(vessel.pose().roll + vessel.pose().pitch + vessel.pose().height));
      largest = std::max(largest, std::abs(vessel.pose().height));
    }
  }
  EXPECT_GT(largest, 0.05);  // they feel one another
  EXPECT_LT(largest, 2.0);   // the freeboard is 1.45 m
}

}  // namespace
}  // namespace seaway::bridge
