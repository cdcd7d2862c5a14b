#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

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

}  // namespace
}  // namespace seaway::bridge
