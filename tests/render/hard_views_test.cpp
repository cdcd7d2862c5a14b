#include "tests/render/hard_views.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <memory>
#include <string>

#include "render/compare_frames.h"
#include "surface/surface_ray.h"

// Cameras and seas that break simpler renderers, drawn by every variant of the projected grid and
// held against rays.
namespace seaway::render {
namespace {

constexpr GridVariant allVariants[] = {GridVariant::software, GridVariant::cpuVertices,
                                       GridVariant::gpu, GridVariant::cpuVerticesGpuNormals,
                                       GridVariant::marched};

std::unique_ptr<RenderTechnique> make(const ProjectedGridOptions& options) {
  if (options.variant == GridVariant::software) return makeSoftwareGrid(options);
  return makeProjectedGrid(test::sharedContext(), options);
}

class ViewsHard : public ::testing::TestWithParam<int> {};

TEST_P(ViewsHard, EveryVariantDrawsWhatRaysFind) {
  const test::HardView view = test::hardViews()[static_cast<std::size_t>(GetParam())];
  const ProjectedGridOptions options{.grid = {128, 256}};
  const Frame truth = test::drawnBy(*makeReference(options), view.water, view.camera, view.time);
  test::expectSane(truth, view.camera.size);
  const long water = std::count(truth.classes.begin(), truth.classes.end(), PixelClass::water);
  EXPECT_EQ(water > 0, view.showsWater) << view.name;
  for (const GridVariant variant : allVariants) {
    SCOPED_TRACE(view.name + ", " + std::string(gridVariantName(variant)));
    const Frame frame = test::drawnBy(*make({.grid = options.grid, .variant = variant}), view.water,
                                      view.camera, view.time);
    test::expectSane(frame, view.camera.size);
    const FrameComparison c = compareFrames(view.camera, frame, truth);
    std::printf("%s, %s: %zu px, rms %.4f, 99 %% %.4f, missing %zu, extra %zu, far %zu\n",
                view.name.c_str(), std::string(gridVariantName(variant)).c_str(), c.compared,
                c.positionRms, c.positionPercentile99, c.missing, c.extra, c.misplaced);
    // The coarse mesh of this variant, 17 x 33 here, has the right waves at its vertices alone.
    const bool isCoarse = variant == GridVariant::cpuVerticesGpuNormals;
    EXPECT_LE(c.missing + c.extra, isCoarse ? 48u : 2u);  // a row of the picture; a crest's rim
    EXPECT_EQ(c.misplaced, 0u);
    if (isCoarse) continue;
    EXPECT_LE(c.positionRms, 0.5);
    EXPECT_LE(c.positionPercentile99, 3.0);
  }
}

INSTANTIATE_TEST_SUITE_P(Each, ViewsHard, ::testing::Range(0, 17));

class VariantsHard : public ::testing::TestWithParam<GridVariant> {};

TEST_P(VariantsHard, PutsTheHorizonAtItsDipToATenthOfAPixel) {
  const WaterSurface still = test::stillSea();
  // The coarse mesh of this variant has an eighth of the rows.
  const auto technique = make({.grid = {64, 1024}, .variant = GetParam()});
  for (const double height : {0.001, 1.0, 100.0, 10000.0}) {
    Camera camera = test::cameraAt({0, 0, height}, 0.0, 0.0, 10.0, {9, 720});
    const double dip = std::acos(earthMeanRadius / (earthMeanRadius + height));
    const double pixel = 2.0 * std::tan(0.5 * camera.verticalFieldOfView) / camera.size.y;
    for (const double off : {-0.1, 0.1}) {
      // The horizon lies `off` pixels above the centre of row 360.
      camera.worldFromCamera = attitude(0.4, -dip + (0.5 - off) * pixel, 0.0);
      const Frame frame = test::drawnBy(*technique, still, camera, 0.0);
      const bool water = frame.classes[360 * 9 + 4] == PixelClass::water;
      EXPECT_EQ(water, off > 0.0) << height << " m, " << off;
    }
  }
}

TEST_P(VariantsHard, APictureOf4096By2160PixelsShowsTheFieldAtItsPixels) {
  const WaterSurface water = test::groupSea(2.0, 7.0);
  // Mostly sky, and a march in fewer rows: software OpenGL marches a pixel in microseconds.
  const int rows = GetParam() == GridVariant::marched ? 108 : 2160;
  const Camera camera = test::cameraAt({10, 20, 9.0}, 19.0, 2.0, 50.0, {4096, rows});
  EffectLedger effects;
  View view;
  view.water = &water;
  view.time = 3.0;
  view.camera = camera;
  view.effects = &effects;
  const Frame frame = make({.grid = {256, 512}, .variant = GetParam()})->draw(view);
  test::expectSane(frame, camera.size);
  const SurfaceAtTime now = water.at(view.time);
  int other = 0;
  std::vector<double> errors;
  for (int y = rows / 72; y < rows; y += rows / 36) {
    for (int x = 64; x < camera.size.x; x += 128) {
      const std::size_t i = static_cast<std::size_t>(y) * camera.size.x + x;
      const glm::dvec3 ray = camera.rayThrough({x, y});
      const auto distance = distanceToWater(now, camera.position, ray);
      const bool drawn = frame.classes[i] == PixelClass::water;
      other += drawn != distance.has_value();
      if (!drawn || !distance) continue;
      const double axial = *distance * glm::dot(ray, camera.forward());
      errors.push_back(std::abs(frame.depth.metres[i] / axial - 1.0));
    }
  }
  ASSERT_GT(errors.size(), 100u);
  std::sort(errors.begin(), errors.end());
  const double median = errors[errors.size() / 2];
  std::printf("%zu pixels, error of depth: median %.5f, largest %.5f; %d of another class\n",
              errors.size(), median, errors.back(), other);
  EXPECT_LE(other, 1);  // on the sky line
  EXPECT_LT(median, GetParam() == GridVariant::cpuVerticesGpuNormals ? 0.03 : 0.003);
}

INSTANTIATE_TEST_SUITE_P(Each, VariantsHard, ::testing::ValuesIn(allVariants),
                         [](const auto& one) { return std::string(gridVariantName(one.param)); });

}  // namespace
}  // namespace seaway::render
