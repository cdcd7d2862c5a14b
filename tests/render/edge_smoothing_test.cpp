#include "render/edge_smoothing.h"

#include <gtest/gtest.h>

namespace seaway::render {
namespace {

/// A dark object with a slanted edge before a bright sky.
Frame slantedEdge(glm::ivec2 size) {
  Frame frame;
  frame.colour.size = frame.depth.size = size;
  for (int y = 0; y < size.y; ++y) {
    for (int x = 0; x < size.x; ++x) {
      const bool object = 4 * y > x + size.y;
      frame.colour.rgb.insert(frame.colour.rgb.end(), 3, object ? 20 : 220);
      frame.depth.metres.push_back(object ? 10.0f : std::numeric_limits<float>::infinity());
      frame.classes.push_back(object ? PixelClass::object : PixelClass::sky);
    }
  }
  return frame;
}

TEST(EdgeSmoothing, GivesOutlinesTonesBetweenAndLeavesTheRestAlone) {
  Frame frame = slantedEdge({64, 48});
  const Frame before = frame;
  smoothEdges(frame.colour, frame.depth, frame.classes);
  int between = 0;
  for (std::size_t i = 0; i < frame.classes.size(); ++i) {
    const int value = frame.colour.rgb[3 * i];
    EXPECT_GE(value, 20);
    EXPECT_LE(value, 220);
    between += value > 40 && value < 200;
    const int y = static_cast<int>(i) / 64, x = static_cast<int>(i) % 64;
    if (std::abs(4 * y - x - 48) > 16) {
      EXPECT_EQ(value, before.colour.rgb[3 * i]);
    }
  }
  EXPECT_GT(between, 40);  // about one a column of 64
}

TEST(EdgeSmoothing, LeavesWavesSharp) {
  Frame frame = slantedEdge({32, 32});
  for (auto& c : frame.classes) c = PixelClass::water;
  for (float& metres : frame.depth.metres) metres = 10.0f;
  const auto before = frame.colour.rgb;
  smoothEdges(frame.colour, frame.depth, frame.classes);
  EXPECT_EQ(frame.colour.rgb, before);
}

TEST(EdgeSmoothing, TakesPicturesTooSmallToHaveEdges) {
  for (const glm::ivec2 size : {glm::ivec2(1, 1), glm::ivec2(2, 9), glm::ivec2(9, 2)}) {
    Frame frame = slantedEdge(size);
    const auto before = frame.colour.rgb;
    smoothEdges(frame.colour, frame.depth, frame.classes);
    EXPECT_EQ(frame.colour.rgb, before);
  }
}

}  // namespace
}  // namespace seaway::render
