#include "sim_bridge/selftest/soak.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "sim_bridge/commands/soak.h"
#include "sim_bridge/scene/scene_loader.h"
#include "tests/sim_bridge/test_support.h"

namespace seaway::bridge {
namespace {

std::vector<SoakReading> readingsOf(std::initializer_list<std::size_t> bytes) {
  std::vector<SoakReading> readings;
  for (const std::size_t each : bytes) {
    const double time = 60.0 * static_cast<double>(readings.size() + 1);
    readings.push_back({time, each, each, 0.0, 0.0});
  }
  return readings;
}

TEST(SoakMemory, IsJudgedFromWhereItHasSettled) {
  const auto readings = readingsOf({50, 100, 101, 97, 100});
  EXPECT_NEAR(memoryChange(readings, &SoakReading::residentBytes, 120.0), 0.03, 1e-12);
  EXPECT_DOUBLE_EQ(memoryChange(readings, &SoakReading::residentBytes, 0.0), 51.0 / 50.0);
}

TEST(SoakMemory, ASlowLeakAddsUp) {
  const auto readings = readingsOf({1000, 1010, 1020, 1030});
  EXPECT_NEAR(memoryChange(readings, &SoakReading::heapBytes, 60.0), 0.03, 1e-12);
}

TEST(SoakMemory, WhereNothingIsCountedNothingChanges) {
  EXPECT_EQ(memoryChange(readingsOf({0, 0}), &SoakReading::heapBytes, 0.0), 0.0);
}

// Ten minutes after a warm-up of five, in wakes of coarser cells than a whole soak has.
TEST(SoakHard, TwoVesselsInEachOthersWakesHoldTheirMemoryAndCanBeResumed) {
  const test::TempFolder folder;
  Scene scene = loadScene(SEAWAY_SOURCE_DIR "/configs/scenes/soak.yaml");
  ASSERT_EQ(scene.vessels.size(), 2u);
  scene.run.duration = 900.0;
  scene.run.size = {160, 90};
  scene.accuracy.wakes.cell = 2.0;
  std::size_t heard = 0;
  const SoakResult result =
      soak(scene, {.every = 60.0, .folder = folder.path()}, [&](const SoakReading&) { ++heard; });
  EXPECT_EQ(heard, 15u);
  EXPECT_EQ(result.stepCount, 9000);
  EXPECT_EQ(result.frames, 15);
  EXPECT_EQ(result.resumedFrom, 840.0);
  EXPECT_TRUE(result.resumes);
  EXPECT_GT(result.steps.percentile(0.99), result.steps.percentile(0.5));
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // they hold what was freed
  // Resident memory settles to that only after an hour or two.
  EXPECT_LE(memoryChange(result.readings, &SoakReading::heapBytes, 300.0), 0.02);
#endif
}

TEST(SoakCommand, TellsMemoryAndStepsByTheHourAndWhetherItResumes) {
  const test::TempFolder folder;
  std::ostringstream told, json;
  SoakOptions options{.scene = test::writeScene(folder).string(),
                      .out = (folder / "out").string(),
                      .hours = 0.005,
                      .every = 6.0,
                      .settled = 6.0};
  runSoak(options, told);
  EXPECT_NE(told.str().find("resumed at 0.00 h: the same bits at the end"), std::string::npos)
      << told.str();
  options.json = true;
  const int status = runSoak(options, json);
  const auto report = nlohmann::json::parse(json.str());
  EXPECT_EQ(report["readings"].size(), 3u);
  EXPECT_TRUE(report["resumes"]);
  EXPECT_GT(report["steps"], 0);
  // So short a run may not have settled: either verdict is one, the same everywhere.
  const bool sound = report["resident_change"] <= 0.02 && report["heap_change"] <= 0.02;
  EXPECT_EQ(report["sound"].get<bool>(), sound);
  EXPECT_EQ(status, sound ? 0 : 1);
}

TEST(SoakCommand, RefusesARunTooShortToBeReadTwice) {
  std::ostringstream out;
  const SoakOptions options{.scene = SEAWAY_SOURCE_DIR "/configs/scenes/soak.yaml",
                            .out = "",
                            .hours = 1.5,
                            .every = 3600.0,
                            .settled = 3600.0};
  const std::string fault = test::inputErrorOf([&] { runSoak(options, out); });
  EXPECT_NE(fault.find("--hours: 5400 s"), std::string::npos) << fault;
}

}  // namespace
}  // namespace seaway::bridge
