#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "tests/render/seas.h"

// The variants of the projected grid against that with the processor's vertices.
namespace seaway::render {
namespace {

struct Comparison {
  double otherClass = 0.0;   // part of pixels that show another class
  double depthMedian = 0.0;  // relative, of pixels that are water in both
  double depthNinety = 0.0;
  double colourMean = 0.0;  // of 255
};

Comparison compared(const Frame& a, const Frame& b) {
  Comparison result;
  std::vector<double> depths;
  const std::size_t pixels = a.classes.size();
  for (std::size_t i = 0; i < pixels; ++i) {
    result.otherClass += (a.classes[i] != b.classes[i]) / static_cast<double>(pixels);
    for (std::size_t c = 0; c < 3; ++c) {
      result.colourMean += std::abs(a.colour.rgb[3 * i + c] - b.colour.rgb[3 * i + c]) /
                           (3.0 * static_cast<double>(pixels));
    }
    if (a.classes[i] != PixelClass::water || b.classes[i] != PixelClass::water) continue;
    depths.push_back(std::abs(a.depth.metres[i] / b.depth.metres[i] - 1.0));
  }
  std::sort(depths.begin(), depths.end());
  if (!depths.empty()) {
    result.depthMedian = depths[depths.size() / 2];
    result.depthNinety = depths[depths.size() * 9 / 10];
  }
  return result;
}

struct Scenery {
  const char* name;
  WaterSurface water;
  Camera camera;
  double time = 3.0;
};

std::vector<Scenery> sceneries() {
  const glm::ivec2 size(160, 90);
  return {
      {"moderate", test::groupSea(1.2, 6.0), test::cameraAt({100.0, 50.0, 6.0}, -12.0)},
      {"mixed, rolled", test::mixedSea(), test::cameraAt({10.0, 20.0, 3.0}, -5.0, 30.0)},
      {"storm among the waves", test::groupSea(9.0, 12.0),
       test::cameraAt({30.0, -20.0, 7.0}, -3.0, 8.0)},
      {"straight down", test::groupSea(1.2, 6.0), test::cameraAt({0.0, 0.0, 20.0}, -90.0)},
      {"from a kilometre up", test::groupSea(3.0, 8.0), test::cameraAt({0.0, 0.0, 1000.0}, -20.0)},
      {"under water, looking up", test::groupSea(1.2, 6.0), test::cameraAt({0.0, 0.0, -8.0}, 25.0)},
      {"wide", test::mixedSea(), test::cameraAt({5.0, 5.0, 5.0}, -30.0, 0.0, 120.0, size)},
      {"150 km from the anchor after 1e7 s", test::mixedSea(),
       test::cameraAt({1.06e5, 1.06e5, 6.0}, -10.0), 1e7}};
}

Frame drawnAs(GridVariant variant, const Scenery& scenery, glm::ivec2 grid) {
  return test::drawn(scenery.water, scenery.camera, scenery.time,
                     {.grid = grid, .variant = variant});
}

class GridVariants : public ::testing::TestWithParam<int> {
 protected:
  Scenery scenery_ = sceneries()[static_cast<std::size_t>(GetParam())];
};

TEST_P(GridVariants, GpuVerticesDrawWhatTheProcessorsDo) {
  const Frame truth = drawnAs(GridVariant::cpuVertices, scenery_, {128, 128});
  const Frame frame = drawnAs(GridVariant::gpu, scenery_, {128, 128});
  const Comparison c = compared(frame, truth);
  std::printf("gpu, %s: other class %.2g, depth %.2g, %.2g, colour %.2g\n", scenery_.name,
              c.otherClass, c.depthMedian, c.depthNinety, c.colourMean);
  EXPECT_EQ(frame.stats.variant, "gpu");
  EXPECT_EQ(frame.stats.vertices, truth.stats.vertices);
  EXPECT_NEAR(frame.stats.vertexEfficiency, truth.stats.vertexEfficiency, 1e-3);
  // Vertices differ by the twin's rounding, some 1e-6 of the distance; a pixel of a crest's rim may change sides.
  EXPECT_LT(c.otherClass, 1e-3);
  EXPECT_LT(c.depthNinety, 1e-5);
  EXPECT_LT(c.colourMean, 0.05);
}

TEST_P(GridVariants, CoarseVerticesWithFineNormalsDrawTheSameSeaMoreRoughly) {
  const Frame truth = drawnAs(GridVariant::cpuVertices, scenery_, {256, 512});
  const Frame frame = drawnAs(GridVariant::cpuVerticesGpuNormals, scenery_, {256, 512});
  const Comparison c = compared(frame, truth);
  std::printf("cpu_vertices_gpu_normals, %s: other class %.2g, depth %.2g, %.2g, colour %.2g\n",
              scenery_.name, c.otherClass, c.depthMedian, c.depthNinety, c.colourMean);
  EXPECT_EQ(frame.stats.vertices, 33u * 65u);
  EXPECT_LT(c.otherClass, 0.03);
  EXPECT_LT(c.depthMedian, 0.03);
}

TEST_P(GridVariants, MarchedSurfaceIsThatOfTheMesh) {
  const Frame truth = drawnAs(GridVariant::cpuVertices, scenery_, {256, 512});
  const Frame frame = drawnAs(GridVariant::marched, scenery_, {256, 512});
  const Comparison c = compared(frame, truth);
  std::printf("marched, %s: other class %.2g, depth %.2g, %.2g, colour %.2g\n", scenery_.name,
              c.otherClass, c.depthMedian, c.depthNinety, c.colourMean);
  EXPECT_LT(c.otherClass, 0.01);
  EXPECT_LT(c.depthMedian, 1e-3);
}

INSTANTIATE_TEST_SUITE_P(EveryScenery, GridVariants, ::testing::Range(0, 8));

}  // namespace
}  // namespace seaway::render
