#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>
#include <vector>

#include "render/png.h"
#include "sim_bridge/selftest/child_run.h"
#include "tests/sim_bridge/test_support.h"

namespace seaway::bridge {
namespace {

using test::Outcome;
using test::readFile;
using test::seaway;
using test::TempFolder;
using test::writeScene;

Outcome sail(const TempFolder& folder, const std::string& out,
             const std::vector<std::string>& more = {},
             const std::vector<std::pair<std::string, std::string>>& replacements = {}) {
  std::vector<std::string> arguments{"run", writeScene(folder, replacements).string(), "--out",
                                     (folder / out).string()};
  arguments.insert(arguments.end(), more.begin(), more.end());
  Outcome outcome = seaway(arguments);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  return outcome;
}

TEST(RunCommand, WritesTelemetryFramesAndSummary) {
  const TempFolder folder;
  const Outcome outcome = sail(folder, "out", {"--json"});
  EXPECT_EQ(folder.files(), (std::vector<std::string>{"launch.yaml", "out/frames/000000.png",
                                                      "out/frames/000001.png", "out/summary.json",
                                                      "out/telemetry.csv", "scene.yaml"}));
  EXPECT_EQ(render::readPng(folder / "out/frames/000001.png").size, glm::ivec2(64, 48));
  const auto summary = nlohmann::json::parse(readFile(folder / "out/summary.json"));
  EXPECT_EQ(summary, nlohmann::json::parse(outcome.out));
  EXPECT_EQ(summary["sea"]["hm0_asked_m"], 1.12);
  // What a parametric sea promises of its octaves: within 2 % of the height asked.
  EXPECT_NEAR(summary["sea"]["hm0_realised_m"].get<double>(), 1.12, 0.02 * 1.12);
  EXPECT_EQ(summary["frames"], 2);
  EXPECT_GT(summary["real_time_factor"].get<double>(), 0.0);
  EXPECT_TRUE(summary["timings_ms"]["draw"].is_number());
}

// A process inherits the most that getrusage says its parent held.
TEST(RunCommandHard, PeakMemoryIsTheRunsOwnWhateverItsHostHolds) {
  constexpr std::size_t held = std::size_t{1} << 30;
  const std::vector<char> host(held, 1);
  const TempFolder folder;
  const ChildOutcome outcome =
      runProgram(SEAWAY_COMMAND, {"run", writeScene(folder).string(), "--out",
                                  (folder / "out").string(), "--fps", "0", "--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto peak = nlohmann::json::parse(outcome.out)["peak_memory_bytes"].get<std::size_t>();
  EXPECT_GT(peak, std::size_t{1} << 20);
  EXPECT_LT(peak, host.size());
}

TEST(RunCommand, TelemetryHasARowAStepWithTheAgreedColumns) {
  const TempFolder folder;
  sail(folder, "out", {"--fps", "0"});
  std::istringstream lines(readFile(folder / "out/telemetry.csv"));
  std::string header;
  std::getline(lines, header);
  EXPECT_EQ(header,
            "time_s,latitude_deg,longitude_deg,height_m,roll_deg,pitch_deg,heading_deg,speed_m_s,"
            "water_height_m,submerged_volume_m3");
  int rows = 0;
  std::string last;
  for (std::string line; std::getline(lines, line); ++rows) last = line;
  EXPECT_EQ(rows, 51);  // 0, 0.02 … 1 s
  EXPECT_EQ(last.substr(0, 2), "1,");
}

TEST(RunCommand, SameSeedGivesTheSameBytesAndAnotherSeedDoesNot) {
  const TempFolder folder;
  sail(folder, "a", {"--fps", "0", "--seed", "5"});
  sail(folder, "b", {"--fps", "3", "--seed", "5"});  // frames between steps change nothing
  sail(folder, "c", {"--fps", "0", "--seed", "6"});
  EXPECT_EQ(readFile(folder / "a/telemetry.csv"), readFile(folder / "b/telemetry.csv"));
  EXPECT_NE(readFile(folder / "a/telemetry.csv"), readFile(folder / "c/telemetry.csv"));
}

TEST(RunCommand, FramesOfARunAreThoseOfRender) {
  const TempFolder folder;
  // Wakes of a run are as good as those that `render` builds anew, but not the same bits.
  sail(folder, "out", {}, {{"run:", "effects: {wake: off}\nrun:"}});
  ASSERT_EQ(seaway({"render", (folder / "scene.yaml").string(), "--time", "0.5", "--out",
                    (folder / "frame.png").string()})
                .status,
            0);
  EXPECT_EQ(readFile(folder / "out/frames/000001.png"), readFile(folder / "frame.png"));
}

TEST(RunCommand, EarlierFramesInTheSameFolderAreRemovedAndOtherFilesKept) {
  const TempFolder folder;
  sail(folder, "out", {"--fps", "4"});
  folder.write("out/frames/notes.png", "mine");
  sail(folder, "out", {"--fps", "1"});
  const auto files = folder.files();
  EXPECT_EQ(std::count(files.begin(), files.end(), "out/frames/000000.png"), 1);
  EXPECT_EQ(std::count(files.begin(), files.end(), "out/frames/000001.png"), 0);
  EXPECT_EQ(std::count(files.begin(), files.end(), "out/frames/notes.png"), 1);
}

TEST(RunCommand, FilesOfVesselsAndCamerasThatAreGoneAreRemovedAndNothingElse) {
  const TempFolder folder;
  sail(folder, "out", {"--fps", "2"},
       {{"cameras:",
         "  - {name: tender, model: launch.yaml, start: {latitude_deg: 28.8785, longitude_deg: "
         "-78.467}}\ncameras:\n  - {name: quay, place: {latitude_deg: 28.878, longitude_deg: "
         "-78.468}, yaw_deg: 90}"}});
  const auto summary = nlohmann::json::parse(readFile(folder / "out/summary.json"));
  EXPECT_EQ(summary["telemetry"],
            (std::vector<std::string>{"telemetry.csv", "telemetry_tender.csv"}));
  for (const char* mine :
       {"out/telemetry_notes.csv", "out/frames/000777.png", "out/frames/bow/notes.txt"}) {
    folder.write(mine, "mine");
  }
  sail(folder, "out", {"--fps", "0"});
  EXPECT_EQ(folder.files(),
            (std::vector<std::string>{
                "launch.yaml", "out/frames/000777.png", "out/frames/bow/notes.txt",
                "out/summary.json", "out/telemetry.csv", "out/telemetry_notes.csv", "scene.yaml"}));
}

TEST(RunCommandHard, ASummaryThatSeawayDidNotWriteLeadsToNoRemoval) {
  const TempFolder folder;
  folder.write("keep.csv", "mine");
  folder.write("frames/000000.png", "mine");
  folder.write("out/summary.json",
               R"({"telemetry": ["../keep.csv", "telemetry/../../keep.csv"],
                   "cameras": ["../..", ""], "frames": 5})");
  sail(folder, "out", {"--fps", "0"});
  EXPECT_EQ(readFile(folder / "keep.csv"), "mine");
  EXPECT_EQ(readFile(folder / "frames/000000.png"), "mine");
  folder.write("out/summary.json", "no json");
  sail(folder, "out", {"--fps", "0"});
}

TEST(RunCommand, SpeedIsAlongTheHeadingNegativeAstern) {
  const TempFolder folder;
  sail(folder, "out", {"--fps", "0"}, {{"speed_m_s: 6", "speed_m_s: -2.5"}});
  std::istringstream lines(readFile(folder / "out/telemetry.csv"));
  std::string line;
  std::getline(lines, line);
  std::getline(lines, line);
  std::istringstream cells(line);
  std::string cell;
  for (int i = 0; i < 8; ++i) std::getline(cells, cell, ',');
  EXPECT_EQ(cell, "-2.5");
}

TEST(RunCommand, FurtherVesselsAndCamerasHaveFilesOfTheirOwn) {
  const TempFolder folder;
  sail(folder, "out", {"--fps", "1"},
       {{"cameras:",
         "  - {name: tender, model: launch.yaml, start: {latitude_deg: 28.8785, longitude_deg: "
         "-78.467}}\ncameras:\n  - {name: quay, place: {latitude_deg: 28.878, longitude_deg: "
         "-78.468}, yaw_deg: 90}"}});
  const auto files = folder.files();
  for (const char* name : {"out/telemetry.csv", "out/telemetry_tender.csv", "out/frames/000000.png",
                           "out/frames/bow/000000.png"}) {
    EXPECT_EQ(std::count(files.begin(), files.end(), name), 1) << name;
  }
}

}  // namespace
}  // namespace seaway::bridge
