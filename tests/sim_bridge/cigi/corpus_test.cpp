#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include "tests/sim_bridge/cigi/fuzz_target.h"

namespace {

TEST(CigiCorpusHard, EveryInputThatFuzzingKeptIsServedOrDropped) {
  const std::filesystem::path folder =
      std::filesystem::path(SEAWAY_SOURCE_DIR) / "tests/sim_bridge/cigi/corpus";
  std::size_t inputs = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    std::ifstream stream(entry.path(), std::ios::binary);
    const std::vector<char> bytes{std::istreambuf_iterator<char>(stream), {}};
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
    ++inputs;
  }
  EXPECT_GT(inputs, 0u);
}

}  // namespace
