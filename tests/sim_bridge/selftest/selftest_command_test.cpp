#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "sim_bridge/scene/scene_loader.h"
#include "tests/sim_bridge/test_support.h"

namespace seaway::bridge {
namespace {

/// A folder of cases: the given ones, on a scene.
void writeCases(const test::TempFolder& folder, const std::string& cases) {
  folder.write("hard_cases.yaml", "cases:\n" + cases + "tests: []\n");
  folder.write("scenes/scene.yaml", test::sceneText());
  folder.write("scenes/launch.yaml", test::vesselText());
}

// A property that cannot hold.
const char* const impossible = R"(  - name: impossible
    area: queries
    property: water is dry
    scene: scenes/scene.yaml
    command: [query, SCENE, --time, 1, --at, "28.878,-78.467", --json]
    expect: {status: works, says: "water is dry"}
)";

// A property that cannot hold: the case is found, made small, and kept with its command.
TEST(SelftestHard, AFailingCaseIsMadeSmallAndKept) {
  const test::TempFolder folder;
  writeCases(folder, impossible);
  const auto outcome = test::seaway({"selftest", "--configs", folder.path().string(), "--count",
                                     "0", "--out", (folder / "kept").string(), "--json"});
  EXPECT_EQ(outcome.status, 1) << outcome.err;
  const auto report = nlohmann::json::parse(outcome.out);
  ASSERT_EQ(report["failures"].size(), 1u);
  EXPECT_EQ(report["failures"][0]["name"], "impossible");
  const std::string kept = test::readFile(report["failures"][0]["file"].get<std::string>());
  EXPECT_NE(kept.find("it does not say 'water is dry'"), std::string::npos) << kept;
  EXPECT_NE(kept.find("seaway query SCENE --time 1"), std::string::npos) << kept;
  EXPECT_LT(kept.size(), test::sceneText().size()) << kept;
  EXPECT_EQ(kept.find("cameras"), std::string::npos) << kept;
  EXPECT_NO_THROW(sceneFromText(kept, folder.path()));  // still a scene
}

TEST(SelftestCommand, ReadmeHasTheListThatItPrints) {
  const auto outcome =
      test::seaway({"selftest", "--list", "--configs", SEAWAY_SOURCE_DIR "/configs"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(test::readFile(SEAWAY_SOURCE_DIR "/README.md").find(outcome.out), std::string::npos)
      << outcome.out;
}

TEST(SelftestCommand, TellsWhatIsNoRegularExpressionAndWhereNoCasesAre) {
  const auto pattern = test::seaway({"selftest", "--only", "["});
  EXPECT_EQ(pattern.status, 2);
  EXPECT_NE(pattern.err.find("--only: '['"), std::string::npos) << pattern.err;
  const test::TempFolder folder;
  const auto none = test::seaway({"selftest", "--configs", folder.path().string()});
  EXPECT_EQ(none.status, 2);
  EXPECT_NE(none.err.find("hard_cases.yaml"), std::string::npos) << none.err;
}

// What fails is told by name, fault and property; areas are counted.
TEST(SelftestCommand, TellsInWordsWhatFailed) {
  const test::TempFolder folder;
  writeCases(folder, impossible);
  const auto outcome =
      test::seaway({"selftest", "--configs", folder.path().string(), "--count", "0"});
  EXPECT_EQ(outcome.status, 1) << outcome.err;
  EXPECT_NE(outcome.out.find("FAILED impossible: it does not say 'water is dry' (water is dry)"),
            std::string::npos)
      << outcome.out;
  EXPECT_NE(outcome.out.find("1 cases in"), std::string::npos) << outcome.out;
}

TEST(SelftestHard, ACaseThatDoesNotEndIsEnded) {
  const test::TempFolder folder;
  writeCases(folder, R"(  - name: endless
    area: service
    property: ends
    scene: scenes/scene.yaml
    command: [serve, SCENE, --metrics, 0]
    expect: {status: works}
)");
  const auto outcome = test::seaway(
      {"selftest", "--configs", folder.path().string(), "--count", "0", "--limit", "2", "--json"});
  EXPECT_EQ(outcome.status, 1) << outcome.err;
  const auto report = nlohmann::json::parse(outcome.out);
  ASSERT_EQ(report["failures"].size(), 1u);
  EXPECT_EQ(report["failures"][0]["fault"], "it did not end");
}

}  // namespace
}  // namespace seaway::bridge
