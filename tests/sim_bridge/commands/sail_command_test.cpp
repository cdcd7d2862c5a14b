#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/sim_bridge/driven_vessel.h"
#include "tests/sim_bridge/test_support.h"

namespace seaway::bridge::test {
namespace {

using Json = nlohmann::json;

std::string scene(const std::string& waypoints) {
  return sceneText(
      {{"turn_deg_s: 1\n", "waypoints: " + waypoints + "\n"}, {"speed_m_s: 6", "speed_m_s: 4"}});
}

TEST(SailCommand, SailsUnderItsOwnPowerAndWritesItsVoyage) {
  const TempFolder folder;
  folder.write("launch.yaml", drivenVessel);
  const auto file =
      folder.write("scene.yaml", scene("[{latitude_deg: 28.879, longitude_deg: -78.4665}]"));
  const auto out = (folder / "out").string();
  const Outcome outcome =
      seaway({"sail", file.string(), "--duration", "20", "--out", out, "--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Json json = Json::parse(outcome.out);
  EXPECT_EQ(json["steps"], 1000);
  EXPECT_LT(json["most_roll_deg"], 40.0);
  EXPECT_GT(json["heave_period_s"], 1.0);
  EXPECT_EQ(json, Json::parse(readFile(folder / "out/voyage.json")));
  std::istringstream lines(readFile(folder / "out/voyage.csv"));
  std::string line;
  std::size_t count = 0;
  while (std::getline(lines, line)) ++count;
  EXPECT_EQ(count, 1001u);
  // The same bits again.
  const std::string first = readFile(folder / "out/voyage.csv");
  seaway({"sail", file.string(), "--duration", "20", "--out", out});
  EXPECT_EQ(readFile(folder / "out/voyage.csv"), first);
}

TEST(SailCommandHard, WhatCannotSailIsRefusedWithItsReason) {
  const TempFolder folder;
  folder.write("launch.yaml", vesselText());
  const auto file =
      folder.write("scene.yaml", scene("[{latitude_deg: 28.879, longitude_deg: -78.4665}]"));
  const Outcome undriven = seaway({"sail", file.string(), "--out", (folder / "o").string()});
  EXPECT_EQ(undriven.status, 2);
  EXPECT_NE(undriven.err.find("no propeller and rudder"), std::string::npos) << undriven.err;
  folder.write("launch.yaml", drivenVessel);
  const Outcome unknown = seaway({"sail", file.string(), "--vessel", "dinghy"});
  EXPECT_EQ(unknown.status, 2);
  EXPECT_NE(unknown.err.find("must be one of: launch"), std::string::npos) << unknown.err;
  const auto far = folder.write("far.yaml", scene("[{latitude_deg: 60, longitude_deg: -78.4665}]"));
  const Outcome range = seaway({"sail", far.string()});
  EXPECT_EQ(range.status, 2);
  EXPECT_NE(range.err.find("waypoints"), std::string::npos) << range.err;
  folder.write("launch.yaml", drivenVessel);
  std::string missing = drivenVessel;
  missing.replace(missing.find("wigley:12,3,0.8,1"), 17, "missing.stl");
  folder.write("launch.yaml", missing);
  const Outcome hull = seaway({"sail", file.string(), "--out", (folder / "o").string()});
  EXPECT_EQ(hull.status, 2);
  EXPECT_NE(hull.err.find("missing.stl"), std::string::npos) << hull.err;
}

}  // namespace
}  // namespace seaway::bridge::test
