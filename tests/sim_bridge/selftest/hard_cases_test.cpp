#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <memory>
#include <regex>
#include <set>
#include <sstream>

#include "sim_bridge/selftest/hard_case.h"
#include "tests/sim_bridge/test_support.h"

namespace seaway::bridge {
namespace {

HardCases catalogue() { return readHardCases(SEAWAY_SOURCE_DIR "/configs/hard_cases.yaml"); }

/// Names of the tests that ctest labels hard.
std::vector<std::string> hardTests() {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(
      popen("ctest --test-dir '" SEAWAY_BUILD_DIR "' -N -L hard 2>/dev/null", "r"), pclose);
  std::string text;
  for (std::array<char, 4096> part; fgets(part.data(), part.size(), pipe.get());) {
    text += part.data();
  }
  std::vector<std::string> names;
  std::istringstream lines(text);
  static const std::regex named(R"(Test +#\d+: (\S+))");
  for (std::string line; std::getline(lines, line);) {
    std::smatch match;
    if (std::regex_search(line, match, named)) names.push_back(match[1]);
  }
  return names;
}

TEST(HardCatalogue, HasEveryCaseOnceWithItsScene) {
  const HardCases all = catalogue();
  EXPECT_GE(all.cases.size(), 50u);
  std::set<std::string> names;
  for (const HardCase& each : all.cases) {
    EXPECT_TRUE(names.insert(each.name).second) << each.name;
    EXPECT_FALSE(each.property.empty());
    const bool wantsScene =
        std::find(each.arguments.begin(), each.arguments.end(), "SCENE") != each.arguments.end();
    EXPECT_EQ(wantsScene, !each.scene.is_null()) << each.name;
  }
}

TEST(HardCatalogue, EveryHardTestBelongsToAnArea) {
  const HardCases all = catalogue();
  const std::vector<std::string> tests = hardTests();
  ASSERT_GT(tests.size(), 300u);
  std::vector<int> found(all.tests.size(), 0);
  for (const std::string& name : tests) {
    bool any = false;
    for (std::size_t i = 0; i < all.tests.size(); ++i) {
      if (!std::regex_search(name, std::regex(all.tests[i].tests))) continue;
      any = true;
      ++found[i];
    }
    EXPECT_TRUE(any) << name << " is in no area of configs/hard_cases.yaml";
  }
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_GT(found[i], 0) << all.tests[i].area;
}

TEST(HardCatalogueHard, MistakesInItAreNamedWithTheirLine) {
  const test::TempFolder folder;
  const auto file = folder.write("hard_cases.yaml",
                                 "cases:\n  - name: a\n    area: b\n    property: c\n"
                                 "    command: [run]\n    expect: {status: maybe}\n");
  const std::string message = test::inputErrorOf([&] { readHardCases(file); });
  EXPECT_NE(message.find("hard_cases.yaml:6"), std::string::npos) << message;
  EXPECT_NE(message.find("works, refuses, either"), std::string::npos) << message;
}

TEST(HardCatalogue, AFailingCaseSaysWhatFailed) {
  HardCase wrong;
  wrong.arguments = {"hull", "wigley:10,1,0.625,0.4", "--json"};
  wrong.expectation = {Expected::refuses, "", false};
  EXPECT_NE(tryCase(wrong, SEAWAY_COMMAND, {}).find("status 0"), std::string::npos);
  wrong.expectation = {Expected::works, "volume", false};
  EXPECT_EQ(tryCase(wrong, SEAWAY_COMMAND, {}), "");
}

}  // namespace
}  // namespace seaway::bridge
