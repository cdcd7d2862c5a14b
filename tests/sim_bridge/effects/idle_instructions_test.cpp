#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>

#include "surface/effects.h"
#include "tests/sim_bridge/test_support.h"
#include "tests/support/valgrind.h"

// Instructions of a step, a batch of samples and a picture, by valgrind: wall time would tell of
// the machine instead.
namespace seaway::bridge {
namespace {

/// Instructions by label, of all that effects_counted counts; empty where they cannot be counted.
std::map<std::string, double> counts(const std::filesystem::path& folder) {
  const std::string command =
      "valgrind --tool=callgrind --instr-atstart=no --dump-line=no --callgrind-out-file=" +
      (folder / "counts").string() + " " SEAWAY_EFFECTS_COUNTED " " + folder.string() +
      " > /dev/null 2>&1";
  std::map<std::string, double> result;
  if (std::system(command.c_str()) != 0) return result;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    std::ifstream file(entry.path());
    std::string label;
    const std::string before = "desc: Trigger: Client Request: ", total = "totals: ";
    for (std::string line; std::getline(file, line);) {
      if (line.rfind(before, 0) == 0) label = line.substr(before.size());
      if (line.rfind(total, 0) == 0 && !label.empty()) {
        result[label] = std::strtod(line.c_str() + total.size(), nullptr);
      }
    }
  }
  return result;
}

/// What asking may take beside a hundredth of all: a few distances and tests of bounds.
constexpr double asking = 3000.0;

void expectNoMore(const std::map<std::string, double>& counts, const std::string& of,
                  const std::string& than) {
  for (const char* what : {" step", " samples", " picture"}) {
    const double has = counts.at(of + what), bare = counts.at(than + what);
    std::printf("%-28s %-8s %10.0f %10.0f %+8.0f\n", of.c_str(), what, has, bare, has - bare);
    EXPECT_LE(has, 1.01 * bare + asking) << of << what;
  }
}

TEST(IdleInstructions, NoEffectTakesAnyWhereItIsNotCalledForOrSwitchedOff) {
  if (!seaway::test::valgrindCanCount()) GTEST_SKIP() << "no valgrind, or a sanitizer";
  const test::TempFolder folder;
  const auto all = counts(folder.path());
  ASSERT_FALSE(all.empty());
  for (const EffectDescription& each : effectDescriptions()) {
    const std::string name(each.name);
    ASSERT_GT(all.at(name + " idle picture"), 1e5);  // something was drawn
    expectNoMore(all, name + " idle", name + " off");
    if (all.contains(name + " bare step")) expectNoMore(all, name + " busy_off", name + " bare");
  }
}

}  // namespace
}  // namespace seaway::bridge
