#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <string>

#include "tests/support/valgrind.h"

// What a sea that may be disturbed costs while nothing disturbs it, in instructions that valgrind
// counts; wall time would tell of the machine instead.
namespace seaway {
namespace {

/// Instructions of sample_counted with these arguments; -1 where they cannot be counted.
double instructionsOf(const std::string& arguments) {
  const std::string command =
      "valgrind --tool=callgrind --callgrind-out-file=/dev/null "
      "--toggle-collect=sampleManyTimes " +
      std::string(SEAWAY_SAMPLE_COUNTED) + " " + arguments + " 2>&1";
  FILE* const pipe = popen(command.c_str(), "r");
  if (!pipe) return -1.0;
  double count = -1.0;
  char line[512];
  while (std::fgets(line, sizeof line, pipe)) {
    const std::string text = line;
    const std::size_t at = text.find("Collected : ");
    if (at != std::string::npos) count = std::strtod(text.c_str() + at + 12, nullptr);
  }
  return pclose(pipe) == 0 ? count : -1.0;
}

TEST(IdleCost, SamplingRunsTheInstructionsOfASeaWithoutTheFeature) {
  if (!test::valgrindCanCount()) GTEST_SKIP() << "no valgrind, or a sanitizer";
  for (const char* points : {"1", "1024"}) {
    const std::string repeats = std::string(points) == "1" ? " 2000" : " 20";
    const double plain = instructionsOf(std::string("plain ") + points + repeats);
    const double idle = instructionsOf(std::string("idle ") + points + repeats);
    ASSERT_GT(plain, 5e6);
    std::printf("%s points: %.4g instructions a call without, %.3g %% more with\n", points,
                plain / std::stod(repeats), 100.0 * (idle / plain - 1.0));
    EXPECT_LT(idle, 1.01 * plain) << points;
  }
}

}  // namespace
}  // namespace seaway
