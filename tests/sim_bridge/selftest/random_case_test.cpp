#include "sim_bridge/selftest/random_case.h"

#include <gtest/gtest.h>

#include "sim_bridge/scene/scene_loader.h"
#include "sim_bridge/selftest/scene_generator.h"
#include "sim_bridge/selftest/yaml_json.h"
#include "surface/input_error.h"
#include "tests/sim_bridge/test_support.h"

namespace seaway::bridge {
namespace {

using Json = nlohmann::ordered_json;

std::vector<std::filesystem::path> examples() {
  const std::filesystem::path scenes = SEAWAY_SOURCE_DIR "/configs/scenes";
  return {scenes / "canaveral.yaml", scenes / "measured.yaml", scenes / "voyage.yaml",
          scenes / "harbour.yaml", scenes / "island.yaml"};
}

bool loads(const Json& scene) {
  try {
    sceneFromText(yamlFromJson(scene), "/tmp");
    return true;
  } catch (const InputError&) {
    return false;
  }
}

TEST(SceneGenerator, TheSameSeedGivesTheSameScene) {
  EXPECT_EQ(SceneGenerator(5, examples()).scene(), SceneGenerator(5, examples()).scene());
  EXPECT_NE(SceneGenerator(5, examples()).scene(), SceneGenerator(6, examples()).scene());
}

TEST(SceneGenerator, TriesEveryKeyOfScenesThatHasAnExample) {
  std::map<std::string, int> given;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const Json scene = SceneGenerator(seed, examples()).scene();
    for (const auto& [key, value] : scene.items()) ++given[key];
  }
  for (const KeyDescription& key : sceneSchema().describe()) {
    if (!key.children.empty() || key.range) {
      EXPECT_GT(given[key.key], 30) << key.key;
    }
  }
}

// What tables cannot say is wrong with some; were it with most, little would be tried.
TEST(SceneGenerator, MostScenesCanBeRead) {
  int read = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    read += loads(SceneGenerator(seed, examples()).scene());
  }
  EXPECT_GT(read, 60);
}

TEST(SceneGeneratorHard, NoBrokenSceneIsRead) {
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    SceneGenerator random(seed, examples());
    Json scene = random.scene();
    const std::string broken = random.breakOne(scene);
    EXPECT_FALSE(loads(scene)) << seed << ": " << broken << "\n" << yamlFromJson(scene);
  }
}

TEST(YamlJson, SurvivesTheRoundTrip) {
  const Json value = {{"a", 1.5},
                      {"b", {{"c", "text: with # marks"}, {"d", {1, 2}}}},
                      {"e", Json::array({{{"f", -3}}, {{"g", "1e3x"}}})}};
  EXPECT_EQ(jsonFromYaml(parseYaml(yamlFromJson(value), "t.yaml")), value);
}

TEST(RandomCase, TriesEveryCommandThatPeopleGive) {
  std::map<std::string, int> commands;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    const HardCase hardCase = randomCase(seed, examples());
    ++commands[hardCase.arguments[0]];
    EXPECT_EQ(hardCase.endpoints > 0, hardCase.arguments[0] == "serve");
  }
  for (const char* command :
       {"run", "query", "render", "explain", "fit", "serve", "hull", "sail", "tune"}) {
    EXPECT_GT(commands[command], 10) << command;
  }
}

TEST(RandomCase, AThirdAreBroken) {
  int broken = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    broken += randomCase(seed, examples()).expectation.status == Expected::refuses;
  }
  EXPECT_GT(broken, 10);
  EXPECT_LT(broken, 50);
}

TEST(Shrinking, LeavesWhatTheFaultNeedsAlone) {
  HardCase hardCase;
  hardCase.scene = SceneGenerator(3, examples()).scene();
  hardCase.scene["light"] = {{"sun", {{"elevation_deg", 3}, {"azimuth_deg", 4}}}};
  const auto fails = [](const HardCase& candidate) {
    return candidate.scene.contains(Json::json_pointer("/light/sun/azimuth_deg"));
  };
  EXPECT_EQ(shrunk(hardCase, fails, 1000).scene,
            (Json{{"light", {{"sun", {{"azimuth_deg", 4}}}}}}));
}

TEST(Shrinking, AsksNoMoreOftenThanAllowed) {
  HardCase hardCase;
  hardCase.scene = SceneGenerator(3, examples()).scene();
  int asked = 0;
  const auto fails = [&](const HardCase&) { return ++asked % 2 == 0; };
  shrunk(hardCase, fails, 7);
  EXPECT_LE(asked, 7);
}

}  // namespace
}  // namespace seaway::bridge
