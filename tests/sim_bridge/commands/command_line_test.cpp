#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/sim_bridge/test_support.h"

namespace seaway::bridge {
namespace {

using test::seaway;
using test::TempFolder;

TEST(CommandLine, EverySubcommandHasHelpWithAnExample) {
  for (const char* command : {"run", "query", "render", "fit", "explain", "cost", "schema"}) {
    const auto outcome = seaway({command, "--help"});
    EXPECT_EQ(outcome.status, 0) << command;
    EXPECT_NE(outcome.out.find("Example"), std::string::npos) << command;
    EXPECT_NE(outcome.out.find("--json"), std::string::npos) << command;
  }
}

TEST(CommandLine, MistakesAreStatusTwo) {
  EXPECT_EQ(seaway({}).status, 2);
  EXPECT_EQ(seaway({"sail"}).status, 2);
  EXPECT_EQ(seaway({"run"}).status, 2);
  EXPECT_EQ(seaway({"schema", "--nonsense"}).status, 2);
  EXPECT_EQ(seaway({"query", "s.yaml", "--time", "soon"}).status, 2);
}

TEST(CommandLine, ExplainTellsEveryEffectAsJson) {
  const test::TempFolder folder;
  const auto outcome =
      seaway({"explain", test::writeScene(folder).string(), "--time", "1", "--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto effects = nlohmann::json::parse(outcome.out)["effects"];
  EXPECT_EQ(effects.size(), effectDescriptions().size());
  for (const auto& effect : effects) {
    EXPECT_TRUE(effect["name"].is_string());
    EXPECT_TRUE(effect["reason"].is_string());
    EXPECT_TRUE(effect["memory_bytes"].is_number());
    EXPECT_TRUE(effect["cost_us"].is_number());
    EXPECT_TRUE(effect["cost_per"] == "step" || effect["cost_per"] == "frame");
    const bool isInside = effect["name"] == "sun" || effect["name"] == "foam" ||
                          effect["name"] == "reflection" || effect["name"] == "refraction" ||
                          effect["name"] == "haze";
    EXPECT_EQ(effect.contains("cost_inside"), isInside) << effect["name"];
    EXPECT_TRUE(effect["state"] == "on" || effect["state"] == "idle" || effect["state"] == "off");
  }
}

TEST(CommandLine, ExplainSaysWhereTheSunsCostIsAndThatFramesAreWarm) {
  const test::TempFolder folder;
  const auto outcome = seaway({"explain", test::writeScene(folder).string()});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("inside water"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("second frame of camera 'bow'"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("us/step"), std::string::npos) << outcome.out;
}

TEST(CommandLine, ExplainTellsOfOneCameraWhatItCallsFor) {
  const test::TempFolder folder;
  const std::string scene =
      test::writeScene(folder, {{"run:",
                                 "  - {name: diver, place: {latitude_deg: 28.878, longitude_deg: "
                                 "-78.467, height_m: -8}, pitch_deg: 20}\nrun:"}})
          .string();
  const auto explained = [&](std::vector<std::string> more) {
    std::vector<std::string> words{"explain", scene, "--json"};
    words.insert(words.end(), more.begin(), more.end());
    const auto outcome = seaway(words);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return nlohmann::json::parse(outcome.out);
  };
  const auto underWater = [](const nlohmann::json& told) -> std::string {
    for (const auto& effect : told["effects"]) {
      if (effect["name"] == "under_water") return effect["state"];
    }
    return "";
  };
  const auto all = explained({}), bow = explained({"--camera", "bow"}),
             diver = explained({"--camera", "diver"});
  EXPECT_EQ(all["cameras"], nlohmann::json({"bow", "diver"}));
  EXPECT_EQ(bow["cameras"], nlohmann::json({"bow"}));
  EXPECT_EQ(diver["frames"], 1);
  EXPECT_EQ(underWater(all), "on");
  EXPECT_EQ(underWater(bow), "idle");
  EXPECT_EQ(underWater(diver), "on");
  const auto unknown = seaway({"explain", scene, "--camera", "driver"});
  EXPECT_EQ(unknown.status, 2);
  EXPECT_NE(unknown.err.find("no camera is called 'driver'; did you mean 'diver'?"),
            std::string::npos)
      << unknown.err;
}

TEST(CommandLine, ExplainSaysWhatIsSwitchedOff) {
  const test::TempFolder folder;
  const auto scene =
      test::writeScene(folder, {{"run:", "effects: {vessel_motion: off, sun: off}\nrun:"}});
  const auto outcome = seaway({"explain", scene.string(), "--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out);
  for (const auto& effect : json["effects"]) {
    if (effect["name"] == "vessel_motion" || effect["name"] == "sun") {
      EXPECT_EQ(effect["state"], "off");
      EXPECT_EQ(effect["cost_us"], 0.0);
    }
  }
}

TEST(CommandLine, SchemaAsJsonListsKeysWithUnitAndRange) {
  const auto outcome = seaway({"schema", "--json"});
  ASSERT_EQ(outcome.status, 0);
  bool found = false;
  const auto json = nlohmann::json::parse(outcome.out);
  for (const auto& document : json["documents"]) {
    for (const auto& key : document["keys"]) {
      if (key["key"] != "sea.state.jonswap.hm0_m") continue;
      found = true;
      EXPECT_EQ(key["unit"], "m");
      EXPECT_EQ(key["allowed"], "> 0");
      EXPECT_TRUE(key["required"]);
    }
  }
  EXPECT_TRUE(found);
}

TEST(ExplainCommand, WhatIsOffCostsNothing) {
  const TempFolder folder;
  const auto scene = test::writeScene(folder);
  std::ofstream file(scene, std::ios::app);
  file << "effects:\n";
  for (const auto& effect : effectDescriptions()) file << "  " << effect.name << ": off\n";
  file.close();
  const auto outcome = seaway({"explain", scene.string(), "--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto report = nlohmann::json::parse(outcome.out);
  for (const auto& effect : report["effects"]) {
    EXPECT_EQ(effect["state"], "off") << effect["name"];
    EXPECT_EQ(effect["memory_bytes"], 0) << effect["name"];
    EXPECT_EQ(effect["cost_us"], 0.0) << effect["name"];
  }
}

}  // namespace
}  // namespace seaway::bridge
