#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "sim_bridge/cost/tuning.h"
#include "sim_bridge/scene/scene_loader.h"
#include "tests/sim_bridge/test_support.h"

namespace seaway::bridge {
namespace {

using test::seaway;
using test::TempFolder;

const std::vector<Setting> settings{{"rough", 3.0, 1.0}, {"fair", 1.0, 2.0}, {"fine", 0.1, 9.0}};
const std::pair<std::string, std::string> units{"m", "ns"};

TEST(ChooseSetting, TakesTheCheapestThatIsExactEnough) {
  EXPECT_EQ(chooseSetting(settings, 1.0, std::nullopt, "heights", units), 1u);
  EXPECT_EQ(chooseSetting(settings, 0.5, std::nullopt, "heights", units), 2u);
}

TEST(ChooseSetting, TakesTheMostExactThatIsAffordable) {
  EXPECT_EQ(chooseSetting(settings, std::nullopt, 2.0, "heights", units), 1u);
  EXPECT_EQ(chooseSetting(settings, std::nullopt, 1e9, "heights", units), 2u);
}

TEST(ChooseSettingHard, SaysWhatIsNearestWhereNothingDoes) {
  const std::string message =
      test::inputErrorOf([] { chooseSetting(settings, 0.5, 2.0, "heights", units); });
  EXPECT_NE(message.find("fine: 0.1 m at 9 ns"), std::string::npos) << message;
  EXPECT_NE(message.find("rough: 3 m at 1 ns"), std::string::npos) << message;
}

TEST(Tune, WritesASceneThatKeepsRemarksAndDoesWhatWasAsked) {
  const TempFolder folder;
  const auto scene = test::writeScene(folder);
  const std::string text = "# a remark\n" + test::readFile(scene);
  folder.write("scene.yaml", text);
  const auto tuned = folder / "tuned.yaml";
  const auto outcome = seaway({"tune", scene.string(), "--out", tuned.string(), "--height-m",
                               "0.05", "--frame-ms", "10000", "--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Scene read = loadScene(tuned);
  EXPECT_LE(read.accuracy.motionTolerance, 0.05);
  EXPECT_EQ(read.accuracy.grid.y, 1024);
  ASSERT_TRUE(read.tuned.height && read.tuned.query && read.tuned.frame && read.tuned.position);
  EXPECT_LE(*read.tuned.height, 0.05);
  EXPECT_FALSE(read.tuned.step);
  EXPECT_EQ(test::readFile(tuned).rfind("# a remark", 0), 0u);
  const auto told = nlohmann::json::parse(outcome.out)["settings"];
  EXPECT_TRUE(told.contains("grid"));
  EXPECT_EQ(told["motion_tolerance_m"], read.accuracy.motionTolerance);
}

TEST(Tune, TakesTheFinestWakesThatABudgetAllows) {
  const TempFolder folder;
  const auto scene = test::writeScene(folder);
  const auto tuned = folder / "tuned.yaml";
  const auto outcome =
      seaway({"tune", scene.string(), "--out", tuned.string(), "--step-us", "1e9"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Scene read = loadScene(tuned);
  ASSERT_TRUE(read.tuned.step);
  EXPECT_GT(*read.tuned.step, 0.0);
  EXPECT_GT(read.accuracy.wakes.cell, 0.0);
  EXPECT_FALSE(read.tuned.height || read.tuned.frame);
  EXPECT_NE(outcome.out.find("accuracy.wakes.cell_m"), std::string::npos) << outcome.out;
}

/// `achieved` of a run of a scene for which a frame was foreseen.
nlohmann::json achievedBy(const std::vector<std::string>& options) {
  const TempFolder folder;
  const auto scene = test::writeScene(folder);
  folder.write("scene.yaml", test::readFile(scene) + "\ntuned: {frame_ms: 8}\n");
  std::vector<std::string> words{"run",    scene.string(), "--out", (folder / "out").string(),
                                 "--json", "--fps",        "4"};
  words.insert(words.end(), options.begin(), options.end());
  const auto outcome = seaway(words);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  return nlohmann::json::parse(outcome.out)["tuned"]["achieved"];
}

TEST(Tune, OnlyFramesLikeThoseThatWereForeseenCount) {
  EXPECT_TRUE(achievedBy({"--duration", "0.5"}).contains("frame_ms"));
  EXPECT_FALSE(achievedBy({"--duration", "0.25"}).contains("frame_ms")) << "the first makes all";
  EXPECT_FALSE(achievedBy({"--duration", "0.5", "--aa", "2"}).contains("frame_ms"));
  EXPECT_FALSE(achievedBy({"--duration", "0.5", "--size", "40x20"}).contains("frame_ms"));
}

TEST(Tune, ARunSetsWhatItAchievesBesideWhatWasForeseen) {
  const TempFolder folder;
  const auto scene = test::writeScene(folder);
  folder.write(
      "scene.yaml",
      test::readFile(scene) + "\ntuned: {height_m: 0.1, query_ns: 9, frame_ms: 8, step_us: 7}\n");
  const auto outcome = seaway({"run", scene.string(), "--out", (folder / "out").string(),
                               "--duration", "0.2", "--fps", "20", "--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto tuned = nlohmann::json::parse(outcome.out)["tuned"];
  EXPECT_EQ(tuned["foreseen"]["query_ns"], 9.0);
  for (const char* key : {"height_m", "query_ns", "frame_ms", "step_us"}) {
    EXPECT_TRUE(tuned["achieved"][key].is_number()) << key;
  }
  EXPECT_EQ(tuned["achieved"]["height_m"], 0.0) << "the scene leaves nothing out";
}

TEST(TuneHard, WhatCannotBeDoneIsToldAndWritesNothing) {
  const TempFolder folder;
  const auto scene = test::writeScene(folder);
  const auto tuned = folder / "tuned.yaml";
  const auto tune = [&](const std::string& option, const std::string& value) {
    return seaway({"tune", scene.string(), "--out", tuned.string(), option, value});
  };
  const auto tooFast = tune("--query-ns", "0.001");
  EXPECT_EQ(tooFast.status, 2);
  EXPECT_NE(tooFast.err.find("cheapest"), std::string::npos) << tooFast.err;
  EXPECT_EQ(tune("--query-ns", "-3").status, 2);
  EXPECT_EQ(tune("--query-ns", "nan").status, 2);
  EXPECT_EQ(seaway({"tune", scene.string(), "--out", tuned.string()}).status, 2);
  EXPECT_FALSE(std::filesystem::exists(tuned));
}

}  // namespace
}  // namespace seaway::bridge
