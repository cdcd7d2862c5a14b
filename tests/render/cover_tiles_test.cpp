#include "render/cover_tiles.h"

#include <gtest/gtest.h>

#include <random>

namespace seaway::render {
namespace {

constexpr glm::ivec2 size{61, 43};  // no multiple of a tile
constexpr int stride = 70;

std::vector<float> sparse(unsigned seed, int things) {
  std::vector<float> values(static_cast<std::size_t>(stride) * size.y, 0.0f);
  std::mt19937 random(seed);
  for (int i = 0; i < things; ++i) {
    values[(random() % size.y) * stride + random() % size.x] = 0.5f;
  }
  // Beyond the image, between its rows.
  for (int y = 0; y < size.y; ++y) values[static_cast<std::size_t>(y) * stride + size.x] = 1.0f;
  return values;
}

bool holds(const std::vector<float>& values, glm::ivec2 first, glm::ivec2 last) {
  for (int y = std::max(first.y, 0); y <= std::min(last.y, size.y - 1); ++y) {
    for (int x = std::max(first.x, 0); x <= std::min(last.x, size.x - 1); ++x) {
      if (values[static_cast<std::size_t>(y) * stride + x] != 0.0f) return true;
    }
  }
  return false;
}

TEST(CoverTiles, NeverDenyWhatABoxHolds) {
  std::mt19937 random(7);
  int denied = 0;
  for (unsigned seed = 0; seed < 20; ++seed) {
    const auto values = sparse(seed, 6);
    CoverTiles tiles;
    tiles.fill(values.data(), size, stride);
    for (int i = 0; i < 500; ++i) {
      const glm::ivec2 first(static_cast<int>(random() % 90) - 15,
                             static_cast<int>(random() % 70) - 15);
      const glm::ivec2 last = first + glm::ivec2(random() % 30, random() % 30);
      if (tiles.mayHold(first, last)) continue;
      ++denied;
      EXPECT_FALSE(holds(values, first, last)) << first.x << ' ' << first.y;
    }
  }
  EXPECT_GT(denied, 2000);  // of 10 000: they do say no
}

TEST(CoverTiles, DenyABoxWhoseTilesAreEmpty) {
  std::vector<float> values(64 * 64, 0.0f);
  values[20 * 64 + 20] = 1.0f;
  CoverTiles tiles;
  tiles.fill(values.data(), {64, 64}, 64);
  EXPECT_TRUE(tiles.mayHold({20, 20}, {20, 20}));
  EXPECT_TRUE(tiles.mayHold({16, 16}, {16, 16})) << "the same tile";
  EXPECT_FALSE(tiles.mayHold({0, 0}, {15, 63}));
  EXPECT_FALSE(tiles.mayHold({24, 0}, {63, 63}));
  EXPECT_FALSE(tiles.mayHold({-1000000, -1000000}, {-1, 1000000}));
  EXPECT_FALSE(tiles.mayHold({64, 64}, {1000000, 1000000}));
  EXPECT_TRUE(tiles.mayHold({-1000000, -1000000}, {1000000, 1000000}));
}

TEST(CoverTiles, ThatNobodyFilledDenyNothing) { EXPECT_TRUE(CoverTiles().mayHold({0, 0}, {1, 1})); }

}  // namespace
}  // namespace seaway::render
