#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "render/exr.h"
#include "render/png.h"
#include "tests/sim_bridge/test_support.h"

namespace seaway::bridge {
namespace {

using test::seaway;
using test::TempFolder;
using test::writeScene;

TEST(RenderCommand, WritesOnePictureAndTellsHowItWasMade) {
  const TempFolder folder;
  const std::string png = (folder / "frame.png").string();
  const auto outcome = seaway({"render", writeScene(folder).string(), "--time", "1.234", "--size",
                               "96x64", "--out", png, "--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json["technique"], "projected_grid");
  EXPECT_TRUE(json["backend"].is_string());
  EXPECT_TRUE(json["passes_ms"].is_object());
  EXPECT_GT(json["vertices"].get<int>(), 0);
  EXPECT_GT(json["vertex_efficiency"].get<double>(), 0.0);
  EXPECT_EQ(render::readPng(png).size, glm::ivec2(96, 64));
  EXPECT_EQ(folder.files(), (std::vector<std::string>{"frame.png", "launch.yaml", "scene.yaml"}));
}

TEST(RenderCommand, SameTimeIsTheSamePicture) {
  const TempFolder folder;
  const std::string scene = writeScene(folder).string();
  for (const char* name : {"a.png", "b.png"}) {
    ASSERT_EQ(seaway({"render", scene, "--time", "2", "--out", (folder / name).string()}).status,
              0);
  }
  EXPECT_EQ(test::readFile(folder / "a.png"), test::readFile(folder / "b.png"));
}

TEST(RenderCommand, UnknownCameraNamesTheNearest) {
  const TempFolder folder;
  const auto outcome = seaway({"render", writeScene(folder).string(), "--time", "0", "--camera",
                               "bo", "--out", (folder / "f.png").string()});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.err.find("did you mean 'bow'?"), std::string::npos) << outcome.err;
}

TEST(RenderCommand, ComparesThePictureWithARayCastOfTheSameSea) {
  const TempFolder folder;
  const auto outcome =
      seaway({"render", writeScene(folder).string(), "--time", "1", "--size", "96x64", "--from",
              "28.9,-78.5,6", "--pitch", "-12", "--grid", "256x256", "--compare", "reference",
              "--stats", "--out", (folder / "f.png").string()});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json["variant"], "software");
  EXPECT_LT(json["compare"]["position_rms_px"].get<double>(), 0.5);
  EXPECT_GT(json["compare"]["compared_px"].get<int>(), 1000);
  EXPECT_EQ(json["compare"]["far_from_silhouettes_px"], 0);
}

TEST(RenderCommand, WritesDepthInMetresAndNormals) {
  const TempFolder folder;
  const std::string depth = (folder / "d.exr").string();
  const auto outcome =
      seaway({"render", writeScene(folder).string(), "--time", "1", "--size", "32x20", "--from",
              "28.9,-78.5,50", "--pitch", "-90", "--depth", depth, "--normals",
              (folder / "n.exr").string(), "--out", (folder / "f.png").string()});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  glm::ivec2 size;
  const auto metres = render::readDepthExr(depth, size);
  EXPECT_EQ(size, glm::ivec2(32, 20));
  // Straight down from 50 m on waves of a metre or two.
  for (const float distance : metres) EXPECT_NEAR(distance, 50.0f, 4.0f);
  EXPECT_TRUE(std::filesystem::exists(folder / "n.exr"));
}

TEST(RenderCommand, RefusesWhatItCannotDrawAndLeavesNothingBehind) {
  const TempFolder folder;
  const std::string scene = writeScene(folder).string();
  const auto before = folder.files();
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases = {
      {{"--technique", "cubes"},
       "projected_grid, radial_grid, post_process, naive_grid, reference"},
      {{"--variant", "cubes"}, "automatic, software"},
      {{"--technique", "reference", "--variant", "software"}, "has none"},
      {{"--grid", "1x9"}, "[2, 4096]"},
      {{"--from", "12,13"}, "LAT,LON,HEIGHT"},
      {{"--from", "91,13,2"}, "latitude"},
      {{"--yaw", "12"}, "without --from"},
      {{"--from", "28,-78,2", "--fov", "190"}, "--fov"},
      {{"--depth", (folder / "d.png").string()}, ".exr"},
      {{"--compare", "cubes"}, "reference"}};
  for (const auto& [arguments, wanted] : cases) {
    std::vector<std::string> all = {"render", scene,   "--time",
                                    "0",      "--out", (folder / "f.png").string()};
    all.insert(all.end(), arguments.begin(), arguments.end());
    const auto outcome = seaway(all);
    EXPECT_EQ(outcome.status, 2) << arguments.front() << ' ' << outcome.err;
    EXPECT_NE(outcome.err.find(wanted), std::string::npos) << outcome.err;
  }
  EXPECT_EQ(folder.files(), before);
}

}  // namespace
}  // namespace seaway::bridge
