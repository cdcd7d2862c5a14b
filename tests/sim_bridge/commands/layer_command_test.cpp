#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "surface/disturbance/layers/layer_file.h"
#include "tests/sim_bridge/test_support.h"

namespace seaway::bridge {
namespace {

using test::seaway;

TEST(LayerCommand, WritesATrailThatOtherToolsAndSeawayRead) {
  const test::TempFolder folder;
  const std::string scene = test::writeScene(folder).string(), file = (folder / "l.vdb").string();
  const test::Outcome written = seaway({"layer", scene, "--time", "8", "--out", file, "--json"});
  ASSERT_EQ(written.status, 0) << written.err;
  const auto grids = nlohmann::json::parse(written.out)["grids"];
  ASSERT_EQ(grids.size(), 4u);
  EXPECT_EQ(grids[0]["name"], "foam");
  EXPECT_EQ(grids[1]["name"], "foam_age");
  EXPECT_EQ(grids[2]["name"], "smooth");
  EXPECT_GT(grids[0]["voxels"], 1000);
  EXPECT_EQ(grids[0]["voxel_m"], 0.25);
  const test::Outcome described = seaway({"layer", file, "--json"});
  EXPECT_EQ(described.status, 0);
  EXPECT_EQ(described.out, written.out);
  EXPECT_EQ(folder.files(), (std::vector<std::string>{"l.vdb", "launch.yaml", "scene.yaml"}));
}

TEST(LayerCommand, WhatItWroteIsASceneLayer) {
  const test::TempFolder folder;
  const std::string scene = test::writeScene(folder).string();
  ASSERT_EQ(seaway({"layer", scene, "--time", "8", "--out", (folder / "l.vdb").string()}).status,
            0);
  const std::string text = test::sceneText(
      {{"speed_m_s: 6", "speed_m_s: 0"},
       {"run: {", "layers: [{kind: foam, file: l.vdb, grid: foam, time_s: 0}]\nrun: {"}});
  const std::string second = folder.write("second.yaml", text).string();
  const test::Outcome again =
      seaway({"layer", second, "--out", (folder / "m.vdb").string(), "--json"});
  ASSERT_EQ(again.status, 0) << again.err;
  EXPECT_GT(nlohmann::json::parse(again.out)["grids"][0]["voxels"], 1000);
}

TEST(LayerCommandHard, BadInputIsNamedAndNothingIsWritten) {
  const test::TempFolder folder;
  const std::string scene = test::writeScene(folder, {{"speed_m_s: 6", "speed_m_s: 0"}}).string();
  const std::string file = (folder / "l.vdb").string();
  const auto fails = [&](const std::vector<std::string>& arguments, const std::string& word) {
    const test::Outcome outcome = seaway(arguments);
    EXPECT_EQ(outcome.status, 2) << word;
    EXPECT_NE(outcome.err.find(word), std::string::npos) << outcome.err;
  };
  fails({"layer", scene, "--out", file}, "nothing lies on the water");
  fails({"layer", scene}, "--out");
  fails({"layer", scene, "--out", "layers.txt"}, ".vdb");
  fails({"layer", scene, "--out", file, "--time", "-1"}, "--time");
  fails({"layer", (folder / "none.vdb").string()}, "no such file");
  folder.write("text.vdb", "oil");
  fails({"layer", (folder / "text.vdb").string()}, "OpenVDB");
  EXPECT_EQ(folder.files(), (std::vector<std::string>{"launch.yaml", "scene.yaml", "text.vdb"}));
}

}  // namespace
}  // namespace seaway::bridge
