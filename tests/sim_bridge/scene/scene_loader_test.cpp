#include "sim_bridge/scene/scene_loader.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/sim_bridge/test_support.h"

namespace seaway::bridge {
namespace {

using test::inputErrorOf;
using test::TempFolder;
using test::writeScene;

using Replacements = std::vector<std::pair<std::string, std::string>>;

std::string faultOf(const Replacements& replacements) {
  const TempFolder folder;
  const auto file = writeScene(folder, replacements);
  std::string message = inputErrorOf([&] { loadScene(file); });
  const std::string prefix = folder.path().string() + "/";
  for (std::size_t at; (at = message.find(prefix)) != std::string::npos;) {
    message.erase(at, prefix.size());
  }
  return message;
}

TEST(SceneLoader, ReadsEveryKeyOfAScene) {
  const TempFolder folder;
  const Scene scene = loadScene(writeScene(folder));
  EXPECT_EQ(scene.sea.anchor.latitude_deg, 28.878);
  EXPECT_TRUE(std::isinf(scene.sea.depth));
  EXPECT_EQ(scene.sea.seed, 7);
  const auto& state = std::get<ParametricState>(scene.sea.state);
  EXPECT_EQ(state.significantWaveHeight, 1.12);
  EXPECT_EQ(state.peakEnhancement, 3.3);  // the default
  ASSERT_EQ(scene.vessels.size(), 1u);
  EXPECT_EQ(scene.vessels[0].start.heading_deg, 30.0);
  EXPECT_NEAR(scene.vessels[0].model.hull.draft(), 0.55, 1e-12);
  ASSERT_EQ(scene.cameras.size(), 1u);
  EXPECT_EQ(scene.cameras[0].mount, "launch");
  EXPECT_EQ(scene.cameras[0].position, glm::dvec3(3.0, 0.0, 3.2));
  EXPECT_EQ(scene.run.size, glm::ivec2(64, 48));
}

TEST(SceneLoader, ReadsEffectsAsAutoOnOrOff) {
  const TempFolder folder;
  const Scene scene =
      loadScene(writeScene(folder, {{"run:", "effects: {sun: off, sky: on}\nrun:"}}));
  EXPECT_EQ(scene.effects[static_cast<std::size_t>(Effect::sun)], EffectSetting::off);
  EXPECT_EQ(scene.effects[static_cast<std::size_t>(Effect::sky)], EffectSetting::on);
  EXPECT_EQ(scene.effects[static_cast<std::size_t>(Effect::water)], EffectSetting::automatic);
  EXPECT_EQ(
      faultOf({{"run:", "effects: {sun: maybe}\nrun:"}}),
      "scene.yaml:21: key 'effects.sun': maybe is not allowed; must be one of: auto, on, off");
}

TEST(SceneLoader, PiersonMoskowitzIsJonswapWithoutPeakEnhancement) {
  const TempFolder folder;
  const Scene scene = loadScene(writeScene(folder, {{"jonswap", "pierson_moskowitz"}}));
  EXPECT_EQ(std::get<ParametricState>(scene.sea.state).peakEnhancement, 1.0);
  EXPECT_NE(faultOf({{"jonswap", "pierson_moskowitz"}, {"tp_s", "gamma: 2\n      tp_s"}})
                .find("unknown key"),
            std::string::npos);
}

TEST(SceneLoader, UnknownKeyNamesTheNearestOne) {
  const std::string message = faultOf({{"      hm0_m: 1.12", "      hm0: 1.12"}});
  EXPECT_EQ(message.rfind("scene.yaml:7: key 'sea.state.jonswap.hm0': unknown key; did you mean "
                          "'hm0_m'?",
                          0),
            0u)
      << message;
}

TEST(SceneLoader, RefusesWavesWithoutHeight) {
  EXPECT_EQ(faultOf({{"1.12", "-1"}}),
            "scene.yaml:7: key 'sea.state.jonswap.hm0_m': -1 is not allowed; must be > 0 m");
  EXPECT_EQ(faultOf({{"1.12", "0"}}),
            "scene.yaml:7: key 'sea.state.jonswap.hm0_m': 0 is not allowed; must be > 0 m");
}

TEST(SceneLoader, RefusesNumbersThatAreNone) {
  EXPECT_EQ(faultOf({{"1.12", ".nan"}}),
            "scene.yaml:7: key 'sea.state.jonswap.hm0_m': .nan is not allowed; must be > 0 m");
  EXPECT_EQ(faultOf({{"5.6", ".inf"}}),
            "scene.yaml:8: key 'sea.state.jonswap.tp_s': .inf is not allowed; must be > 0 s");
}

TEST(SceneLoader, RefusesLatitude91) {
  EXPECT_EQ(
      faultOf({{"28.878", "91"}}),
      "scene.yaml:2: key 'sea.anchor.latitude_deg': 91 is not allowed; must be in [-90, 90] °");
}

TEST(SceneLoader, RefusesImagesWithoutPixels) {
  EXPECT_EQ(
      faultOf({{"[64, 48]", "[0, 48]"}}),
      "scene.yaml:21: key 'run.size[0]': 0 is not allowed; must be a whole number in [1, 8192]");
}

TEST(SceneLoader, NamesMissingKeysWithTheirMeaning) {
  EXPECT_EQ(faultOf({{"      tp_s: 5.6\n", ""}}),
            "scene.yaml:6: key 'sea.state.jonswap': lacks 'tp_s' (peak period)");
}

TEST(SceneLoader, WantsExactlyOneSeaState) {
  const std::string message = faultOf({{"    jonswap:", "    calm: {}\n    jonswap:"}});
  EXPECT_NE(message.find("needs exactly one of: calm, jonswap"), std::string::npos) << message;
}

TEST(SceneLoader, RefusesTwoVesselsOfOneName) {
  const std::string second =
      "  - {name: launch, model: launch.yaml, start: {latitude_deg: 28, longitude_deg: -78}}\n";
  EXPECT_EQ(faultOf({{"cameras:", second + "cameras:"}}),
            "scene.yaml:16: key 'vessels[1].name': 'launch' is given twice");
}

TEST(SceneLoader, RefusesNamesThatWouldLeaveTheOutputFolder) {
  EXPECT_EQ(faultOf({{"name: bow", "name: ../bow"}}),
            "scene.yaml:17: key 'cameras[0].name': '../bow' is not allowed; must be of letters, "
            "digits, _ and -");
}

TEST(SceneLoader, RefusesAMountThatIsNoVessel) {
  EXPECT_EQ(faultOf({{"mount: launch", "mount: lunch"}}),
            "scene.yaml:18: key 'cameras[0].mount': no vessel is called 'lunch'; did you mean "
            "'launch'?");
}

TEST(SceneLoader, RefusesACameraBothMountedAndFixed) {
  const std::string place = "place: {latitude_deg: 28.878, longitude_deg: -78.467}\n    fov_deg";
  EXPECT_NE(faultOf({{"fov_deg", place}}).find("exactly one of mount and place"),
            std::string::npos);
  EXPECT_NE(faultOf({{"    mount: launch\n", ""}}).find("exactly one of mount and place"),
            std::string::npos);
}

TEST(SceneLoader, MissingVesselFileNamesBothFiles) {
  EXPECT_EQ(faultOf({{"launch.yaml", "boat.yaml"}}),
            "scene.yaml:12: key 'vessels[0].model': no such file: boat.yaml");
}

TEST(SceneLoader, FaultsInTheVesselFileNameThatFile) {
  const TempFolder folder;
  const auto scene = writeScene(folder);
  folder.write("launch.yaml", test::vesselText({{"beam_m: 3.6", "beam_m: -3.6"}}));
  const std::string message = inputErrorOf([&] { loadScene(scene); });
  EXPECT_NE(message.find("launch.yaml:4: key 'hull.beam_m': -3.6 is not allowed; must be > 0 m"),
            std::string::npos)
      << message;
}

TEST(SceneLoader, RefusesHullsThatSinkOrCapsize) {
  const auto message = [](const Replacements& replacements) {
    const TempFolder folder;
    const auto scene = writeScene(folder);
    folder.write("launch.yaml", test::vesselText(replacements));
    return inputErrorOf([&] { loadScene(scene); });
  };
  EXPECT_NE(message({{"draft_m: 0.55", "draft_m: 2.5"}}).find("would sink"), std::string::npos);
  EXPECT_NE(message({{"keel_m: 1.25", "keel_m: 9"}}).find("would capsize"), std::string::npos);
  EXPECT_NE(message({{"draft_m: 0.55", "draft_m: 0.55\n  mass_kg: 1000"}}).find("exactly one of"),
            std::string::npos);
}

TEST(SceneLoader, RefusesAStartBeyondTheGeodesysRange) {
  EXPECT_NE(faultOf({{"start: {latitude_deg: 28.878", "start: {latitude_deg: 38"}})
                .find("farther than 500 km"),
            std::string::npos);
}

TEST(SceneLoader, RefusesAnEmptyFile) {
  const TempFolder folder;
  const auto file = folder.write("empty.yaml", "# nothing\n");
  EXPECT_NE(inputErrorOf([&] { loadScene(file); }).find("is empty"), std::string::npos);
}

}  // namespace
}  // namespace seaway::bridge
