#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <memory>
#include <random>
#include <tuple>

#include "render/compare_frames.h"
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

/// Draws with techniques that are kept: making one takes longer than most frames.
Frame drawnAs(GridVariant variant, const Scenery& scenery, glm::ivec2 grid) {
  HeadlessContext& context = test::sharedContext();  // outlives the techniques
  static std::map<std::tuple<GridVariant, int, int>, std::unique_ptr<RenderTechnique>> techniques;
  auto& technique = techniques[{variant, grid.x, grid.y}];
  if (!technique) technique = makeProjectedGrid(context, {.grid = grid, .variant = variant});
  EffectLedger effects;
  View view;
  view.water = &scenery.water;
  view.camera = scenery.camera;
  view.time = scenery.time;
  view.effects = &effects;
  return technique->draw(view);
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
  // Vertices differ by the twin's rounding, some 1e-6 of the distance; a pixel of a crest's rim may
  // change sides.
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

TEST_P(GridVariants, MarchedSurfaceLiesWhereTheReferenceIs) {
  EffectLedger effects;
  View view;
  view.water = &scenery_.water;
  view.camera = scenery_.camera;
  view.time = scenery_.time;
  view.effects = &effects;
  view.wantsNormals = true;
  const ProjectedGridOptions options{.grid = {128, 256}, .variant = GridVariant::marched};
  const Frame reference = makeReference(options)->draw(view);
  const auto against = [&](GridVariant variant) {
    return compareFrames(view.camera, drawnAs(variant, scenery_, options.grid), reference);
  };
  const FrameComparison mesh = against(GridVariant::cpuVertices);
  const FrameComparison marched = against(GridVariant::marched);
  std::printf(
      "%s against the reference: mesh %.3f px rms, %.3f at 99 %%, %zu + %zu pixels; marched "
      "%.3f, %.3f, %zu + %zu\n",
      scenery_.name, mesh.positionRms, mesh.positionPercentile99, mesh.missing, mesh.extra,
      marched.positionRms, marched.positionPercentile99, marched.missing, marched.extra);
  // The march meets the field itself, the mesh is flat between its vertices.
  EXPECT_LT(marched.positionRms, 0.01);
  EXPECT_LT(marched.positionRms, mesh.positionRms + 0.01);
  EXPECT_LE(marched.misplaced, mesh.misplaced);
}

INSTANTIATE_TEST_SUITE_P(EveryScenery, GridVariants, ::testing::Range(0, 8));

/// A camera anywhere, looking anywhere, over a sea of any height.
Scenery anyScenery(std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const double waveHeight = 15.0 * unit(random) * unit(random);
  const double deep = -20.0 * unit(random), high = std::pow(10.0, 4.0 * unit(random));
  Scenery scenery{
      "random", waveHeight > 0.2 ? test::groupSea(waveHeight, 5.0 + waveHeight) : test::stillSea(),
      test::cameraAt({1e4 * unit(random), -1e4 * unit(random), unit(random) < 0.2 ? deep : high},
                     -90.0 + 180.0 * unit(random), 360.0 * unit(random), 5.0 + 115.0 * unit(random),
                     {48, 32}),
      1e4 * unit(random)};
  return scenery;
}

TEST(GridVariantsHard, RandomCamerasSeeTheSameWaterByEveryVariant) {
  std::mt19937_64 random(3);
  const glm::ivec2 grid(128, 256);
  int pixels = 0, meshDiffers = 0, marchDiffers = 0;
  for (int i = 0; i < 60; ++i) {
    const Scenery scenery = anyScenery(random);
    const Frame truth = drawnAs(GridVariant::cpuVertices, scenery, grid);
    const auto differing = [&](const Frame& frame) {
      int count = 0;
      for (std::size_t p = 0; p < truth.classes.size(); ++p) {
        EXPECT_FALSE(std::isnan(frame.depth.metres[p])) << "camera " << i;
        EXPECT_GT(frame.depth.metres[p], 0.0f) << "camera " << i;
        count += frame.classes[p] != truth.classes[p];
      }
      return count;
    };
    pixels += static_cast<int>(truth.classes.size());
    meshDiffers += differing(drawnAs(GridVariant::gpu, scenery, grid));
    const int differs = differing(drawnAs(GridVariant::marched, scenery, grid));
    marchDiffers += differs;
    // The sky line is as long as the picture is wide at most.
    EXPECT_LE(differs, 24) << "camera " << i << " at " << scenery.camera.position.z << " m";
  }
  std::printf("random cameras: of %d pixels %d differ with GPU vertices, %d marched\n", pixels,
              meshDiffers, marchDiffers);
  EXPECT_LT(meshDiffers, pixels / 2000);
  EXPECT_LT(marchDiffers, pixels / 500);
}

TEST(GridVariantsHard, OddCamerasAndSeasAreDrawnByEveryVariant) {
  const auto at = [](double height, double pitch, double fov, glm::ivec2 size) {
    return test::cameraAt({3.0, 4.0, height}, pitch, 0.0, fov, size);
  };
  const WaterSurface moderate = test::groupSea(1.2, 6.0), huge = test::groupSea(30.0, 18.0);
  const WaterSurface still = test::stillSea();
  const double crest = moderate.sample({3.0, 4.0}, 3.0).height;
  const Scenery odd[] = {{"on the surface", moderate, at(crest, -5.0, 60.0, {32, 18})},
                         {"just below it", moderate, at(crest - 0.02, 10.0, 60.0, {32, 18})},
                         {"a millimetre above still water", still, at(0.001, 0.0, 60.0, {32, 18})},
                         {"still water", still, at(5.0, -20.0, 60.0, {32, 18})},
                         {"straight up from below", moderate, at(-5.0, 90.0, 60.0, {32, 18})},
                         {"straight up from above", moderate, at(5.0, 90.0, 60.0, {32, 18})},
                         {"30 m waves", huge, at(10.0, -10.0, 60.0, {32, 18})},
                         {"a narrow view", moderate, at(6.0, -3.0, 0.01, {32, 18})},
                         {"a wide view", moderate, at(6.0, -20.0, 170.0, {32, 18})},
                         {"one pixel", moderate, at(6.0, -20.0, 60.0, {1, 1})}};
  for (const Scenery& scenery : odd) {
    const Frame truth = drawnAs(GridVariant::cpuVertices, scenery, {64, 128});
    for (const GridVariant variant :
         {GridVariant::gpu, GridVariant::cpuVerticesGpuNormals, GridVariant::marched}) {
      const Frame frame = drawnAs(variant, scenery, {64, 128});
      int differ = 0;
      for (std::size_t p = 0; p < frame.classes.size(); ++p) {
        ASSERT_FALSE(std::isnan(frame.depth.metres[p])) << scenery.name;
        differ += frame.classes[p] != truth.classes[p];
      }
      // Within the nearest waves a coarser mesh may be clipped elsewhere.
      const int allowed = variant == GridVariant::gpu ? 0 : 32 * 18 / 10;
      EXPECT_LE(differ, allowed) << scenery.name << ", " << gridVariantName(variant);
    }
  }
}

}  // namespace
}  // namespace seaway::render
