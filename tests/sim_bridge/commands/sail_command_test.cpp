#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/sim_bridge/test_support.h"

namespace seaway::bridge::test {
namespace {

using Json = nlohmann::json;

const std::string driven = R"(hull:
  length_m: 12
  beam_m: 3.0
  depth_m: 1.8
  mass_kg: 13131
  centre_of_gravity_above_keel_m: 0.9
mesh: {source: "wigley:12,3,0.8,1", triangles: 120, form_drag: 0.2, level: mesh}
propeller: {diameter_m: 0.6, position_m: [-5, 0, -0.45], most_revolutions_s: 25}
rudder: {area_m2: 0.35, position_m: [-5.6, 0, -0.4], most_rate_deg_s: 15}
)";

std::string scene(const std::string& waypoints) {
  return sceneText(
      {{"turn_deg_s: 1\n", "waypoints: " + waypoints + "\n"}, {"speed_m_s: 6", "speed_m_s: 4"}});
}

TEST(SailCommand, SailsUnderItsOwnPowerAndWritesItsVoyage) {
  const TempFolder folder;
  folder.write("launch.yaml", driven);
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
  folder.write("launch.yaml", driven);
  const Outcome unknown = seaway({"sail", file.string(), "--vessel", "dinghy"});
  EXPECT_EQ(unknown.status, 2);
  EXPECT_NE(unknown.err.find("must be one of: launch"), std::string::npos) << unknown.err;
  const auto far = folder.write("far.yaml", scene("[{latitude_deg: 60, longitude_deg: -78.4665}]"));
  const Outcome range = seaway({"sail", far.string()});
  EXPECT_EQ(range.status, 2);
  EXPECT_NE(range.err.find("waypoints"), std::string::npos) << range.err;
  folder.write("launch.yaml", driven + "");
  std::string missing = driven;
  missing.replace(missing.find("wigley:12,3,0.8,1"), 17, "missing.stl");
  folder.write("launch.yaml", missing);
  const Outcome hull = seaway({"sail", file.string(), "--out", (folder / "o").string()});
  EXPECT_EQ(hull.status, 2);
  EXPECT_NE(hull.err.find("missing.stl"), std::string::npos) << hull.err;
}

}  // namespace
}  // namespace seaway::bridge::test
