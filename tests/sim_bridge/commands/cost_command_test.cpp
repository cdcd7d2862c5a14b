#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/sim_bridge/test_support.h"

namespace seaway::bridge {
namespace {

using test::seaway;
using test::TempFolder;
using test::writeScene;

const nlohmann::json& studyCalled(const nlohmann::json& report, const std::string& name) {
  for (const auto& study : report["studies"]) {
    if (study["name"] == name) return study;
  }
  throw std::runtime_error("no study " + name);
}

TEST(CostCommand, EveryStudyHasAFallingErrorAndAPositiveCost) {
  const TempFolder folder;
  const auto outcome = seaway({"cost", writeScene(folder).string(), "--out",
                               (folder / "cost").string(), "--quick", "--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto report = nlohmann::json::parse(outcome.out);
  for (const char* name :
       {"query_octaves", "fit_octaves", "hull_mesh_dynamic", "hull_cutoffs", "image_position_grid",
        "image_depth_grid", "image_height_grid", "image_swimming", "image_swimming_turning",
        "image_octaves", "picture_resolution", "wake_cell", "wake_step", "wake_window",
        "layer_memory", "layer_painting", "layer_sampling"}) {
    const auto& study = studyCalled(report, name);
    ASSERT_GE(study["points"].size(), 3u) << name;
    EXPECT_TRUE(study["unit_error"].is_string());
    EXPECT_LT(study["points"].back()["error"].get<double>(),
              0.5 * study["points"].front()["error"].get<double>())
        << name;
    for (const auto& point : study["points"]) EXPECT_GT(point["cost"].get<double>(), 0.0);
  }
  const auto& wasted = studyCalled(report, "image_wasted_vertices")["points"];
  ASSERT_EQ(wasted.size(), 2u);
  EXPECT_LT(wasted[1]["error"].get<double>(), 0.2);
  EXPECT_LT(wasted[1]["error"].get<double>(), wasted[0]["error"].get<double>());
  EXPECT_EQ(nlohmann::json::parse(test::readFile(folder / "cost/cost.json")), report);
  const std::string table = test::readFile(folder / "cost/cost.csv");
  EXPECT_TRUE(table.starts_with("study,setting,error,"));
  // A setting may have a comma; it is quoted.
  EXPECT_NE(table.find("\npicture_resolution,\"320x180, 4 samples\","), table.npos);
  const std::string page = test::readFile(folder / "cost/report.html");
  std::size_t figures = 0;
  for (auto at = page.find("<svg"); at != page.npos; at = page.find("<svg", at + 1)) ++figures;
  // Octaves of queries, of pictures and of fits, size of pictures, four of hulls, three of layers,
  // three of wakes, pictures by the grid's size and by cost, two by technique, predicted against
  // measured errors; and shadows, where the launch shades itself.
  std::size_t ofLight = 0;
  for (const auto& study : report["studies"]) {
    ofLight += study["name"].get<std::string>().starts_with("light_");
  }
  EXPECT_EQ(figures, 19u + ofLight);
  EXPECT_NE(page.find("vertices a side"), page.npos);
  EXPECT_TRUE(test::readFile(folder / "cost/height_error.svg").find("<svg") != std::string::npos);
  ASSERT_GE(report["advice"].size(), 3u);
  EXPECT_NE(page.find(report["advice"][1].get<std::string>()), page.npos);
}

TEST(CostCommand, RefusesAFolderItCannotWriteBeforeAnyWork) {
  const TempFolder folder;
  const auto outcome = seaway({"cost", writeScene(folder).string(), "--out", "/proc/nowhere"});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.err.find("/proc/nowhere"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace seaway::bridge
