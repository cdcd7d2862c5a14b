#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "render/compare_frames.h"
#include "surface/surface_ray.h"
#include "tests/render/random_views.h"

namespace seaway::render {
namespace {

struct Pair {
  Frame drawn, truth;
};

Pair drawBoth(const WaterSurface& water, const Camera& camera, double time, glm::ivec2 grid) {
  return {test::drawnBy(*makeSoftwareGrid({.grid = grid}), water, camera, time),
          test::drawnBy(*makeReference({.grid = grid}), water, camera, time)};
}

TEST(Reference, FindsWhatTheRayQueryFindsWhereTheGridCarriesAllWaves) {
  const WaterSurface water = test::moderateSea();
  const Camera camera = test::cameraAt({3, 4, 3}, -35.0, 0.0, 40.0, {40, 30});
  EffectLedger effects;
  View view;
  view.water = &water;
  view.time = 2.0;
  view.camera = camera;
  view.effects = &effects;
  const Frame frame = makeReference({.grid = {1024, 1024}})->draw(view);
  for (int y = 0; y < 30; ++y) {
    for (int x = 0; x < 40; ++x) {
      const glm::dvec3 ray = camera.rayThrough({x, y});
      const auto distance = distanceToWater(water.at(2.0), camera.position, ray);
      ASSERT_TRUE(distance.has_value());
      // The query's tolerance is 1e-4 m; float depth rounds to 1e-6 of some metres.
      EXPECT_NEAR(frame.depth.metres[y * 40 + x], *distance * glm::dot(ray, camera.forward()),
                  2e-4);
    }
  }
}

/// Nothing that no sea could show.
void expectSane(const Frame& frame) {
  for (std::size_t i = 0; i < frame.classes.size(); ++i) {
    const float depth = frame.depth.metres[i];
    ASSERT_FALSE(std::isnan(depth));
    ASSERT_GT(depth, 0.0f);
    ASSERT_EQ(std::isinf(depth), frame.classes[i] == PixelClass::sky);
    const float length = glm::dot(frame.normals[i], frame.normals[i]);
    ASSERT_NEAR(length, frame.classes[i] == PixelClass::sky ? 0.0f : 1.0f, 1e-4f);
  }
}

class ReferenceHard : public ::testing::TestWithParam<test::SeaKind> {};

TEST_P(ReferenceHard, GridAgreesFromCamerasAnywhere) {
  double worstRms = 0.0, worstPercentile = 0.0, worstMismatch = 0.0;
  for (std::uint64_t i = 0; i < 16; ++i) {
    const test::RandomView v = test::randomView(i, {96, 60}, GetParam());
    const Pair pair = drawBoth(v.water, v.camera, v.time, {512, 1024});
    expectSane(pair.drawn);
    const FrameComparison c = compareFrames(v.camera, pair.drawn, pair.truth);
    const double mismatch = static_cast<double>(c.missing + c.extra) / (96 * 60);
    worstRms = std::max(worstRms, c.positionRms);
    worstPercentile = std::max(worstPercentile, c.positionPercentile99);
    worstMismatch = std::max(worstMismatch, mismatch);
    EXPECT_LE(c.positionRms, 0.5) << "view " << i;
    EXPECT_LE(c.positionPercentile99, 3.0) << "view " << i;
    EXPECT_LE(c.misplaced, 0u) << "view " << i;
    // At this size a pixel of the sky line is a larger part of the picture than at 640x400.
    EXPECT_LE(mismatch, 0.003 * 640 / 96) << "view " << i;
  }
  std::printf("worst of 16: %.3f px rms, %.3f px 99 %%, %.4f of the pixels of another class\n",
              worstRms, worstPercentile, worstMismatch);
}

INSTANTIATE_TEST_SUITE_P(Seas, ReferenceHard,
                         ::testing::Values(test::SeaKind::perlin, test::SeaKind::group),
                         [](const auto& one) {
                           return one.param == test::SeaKind::perlin ? "perlin" : "group";
                         });

}  // namespace
}  // namespace seaway::render
