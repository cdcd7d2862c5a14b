#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "surface/curvature.h"
#include "surface/input_error.h"
#include "surface/surface_ray.h"
#include "tests/render/seas.h"

namespace seaway::render {
namespace {

using test::cameraAt;
using test::drawn;

/// Pixels of a still sea whose class is not what the ray through them meets, leaving out those
/// whose ray passes the horizon by less than `nearHorizon` pixels.
int wrongPixels(const Camera& camera, double nearHorizon) {
  const WaterSurface still = test::stillSea();
  const Frame frame = drawn(still, camera, 0.0, {.grid = {64, 64}});
  const double pixelAngle = 2.0 * std::tan(0.5 * camera.verticalFieldOfView) / camera.size.y;
  const double horizon = -std::atan(std::sqrt(2.0 * camera.position.z / earthMeanRadius));
  int wrong = 0;
  for (int y = 0; y < camera.size.y; ++y) {
    for (int x = 0; x < camera.size.x; ++x) {
      const glm::dvec3 ray = camera.rayThrough({x, y});
      const double elevation = std::asin(ray.z);
      if (std::abs(elevation - horizon) < nearHorizon * pixelAngle) continue;
      const bool water = frame.classes[y * camera.size.x + x] == PixelClass::water;
      wrong += water != (elevation < horizon);
    }
  }
  return wrong;
}

TEST(ProjectedGrid, StillSeaFillsEveryWaterPixelAndNoOther) {
  for (const double z : {0.3, 3.0, 40.0, 3000.0}) {
    for (const double pitch : {-90.0, -50.0, -20.0, -3.0, 10.0, 25.0}) {
      for (const double roll : {0.0, 30.0, 90.0}) {
        // Between the last rows of a coarse grid the horizon is a chord: half a pixel.
        EXPECT_EQ(wrongPixels(cameraAt({9.0, 5.0, z}, pitch, roll), 0.5), 0)
            << z << " m, pitch " << pitch << ", roll " << roll;
      }
    }
  }
}

TEST(ProjectedGrid, DepthOfStillSeaIsThatOfTheParaboloid) {
  const WaterSurface still = test::stillSea();
  const SurfaceAtTime now = still.at(0.0);
  const Camera camera = cameraAt({0, 0, 5.0}, -20.0);
  const Frame frame = drawn(still, camera, 0.0, {.grid = {256, 256}});
  for (int y = 0; y < camera.size.y; ++y) {
    for (int x = 0; x < camera.size.x; ++x) {
      const float depth = frame.depth.metres[y * camera.size.x + x];
      const glm::dvec3 ray = camera.rayThrough({x, y});
      const auto truth = distanceToWater(now, camera.position, ray);
      if (!truth) {
        EXPECT_EQ(depth, std::numeric_limits<float>::infinity());
      } else if (*truth < 200.0) {
        // Chords between rows lie spacing²/8R below the sea, which grazing rays magnify.
        EXPECT_NEAR(depth, *truth * glm::dot(ray, camera.forward()), 1e-3 * *truth);
      }
    }
  }
}

TEST(ProjectedGrid, SameViewGivesTheSameBytesFromTheSameAndFromAnotherTechnique) {
  const WaterSurface water = test::moderateSea();
  const Camera camera = cameraAt({12.0, 3.0, 3.0}, -5.0);
  const auto technique = makeProjectedGrid(test::sharedContext(), {.grid = {96, 96}});
  EffectLedger effects;
  View view;
  view.water = &water;
  view.time = 2.0;
  view.camera = camera;
  view.effects = &effects;
  const Frame first = technique->draw(view);
  view.time = 3.0;
  const Frame other = technique->draw(view);
  view.time = 2.0;
  const Frame again = technique->draw(view);
  const Frame elsewhere = drawn(water, camera, 2.0, {.grid = {96, 96}});
  EXPECT_EQ(first.colour.rgb, again.colour.rgb);
  EXPECT_EQ(first.colour.rgb, elsewhere.colour.rgb);
  EXPECT_EQ(first.depth.metres, elsewhere.depth.metres);
  EXPECT_NE(first.colour.rgb, other.colour.rgb);
}

TEST(ProjectedGrid, StatisticsSayHowTheFrameWasMade) {
  const WaterSurface water = test::moderateSea();
  const Frame frame = drawn(water, cameraAt({0, 0, 4}, -8.0), 0.0, {.grid = {80, 60}});
  EXPECT_EQ(frame.stats.technique, "projected_grid");
  EXPECT_EQ(frame.stats.backend, "osmesa");
  EXPECT_FALSE(frame.stats.renderer.empty());
  EXPECT_EQ(frame.stats.vertices, 80u * 60u);
  EXPECT_GT(frame.stats.vertexEfficiency, 0.3);
  EXPECT_LE(frame.stats.vertexEfficiency, 1.0);
  ASSERT_GE(frame.stats.passesMs.size(), 5u);
  EXPECT_EQ(frame.stats.passesMs.front().first, "vertices");
  EXPECT_EQ(frame.stats.boundRedraws, 0u);
}

TEST(ProjectedGrid, FarWaterIsAsBrightAsItsSlopesMakeItAndNotAMirror) {
  // Just below the horizon a flat mirror would show the sky just above it; waves tilted towards
  // the viewer show higher, darker sky and less of it.
  const WaterSurface water = test::moderateSea();
  Camera camera = cameraAt({0, 0, 4}, 0.0, 0.0, 20.0);
  const Frame frame = drawn(water, camera);
  const auto brightness = [&](int row) {
    double sum = 0.0;
    for (int x = 0; x < camera.size.x; ++x) {
      for (int c = 0; c < 3; ++c) sum += frame.colour.rgb[3 * (row * camera.size.x + x) + c];
    }
    return sum;
  };
  EXPECT_LT(brightness(52), 0.93 * brightness(40));
}

TEST(ProjectedGrid, OptionsOutOfRangeAreRefused) {
  HeadlessContext& context = test::sharedContext();
  EXPECT_THROW(makeProjectedGrid(context, {.grid = {1, 64}}), InputError);
  EXPECT_THROW(makeProjectedGrid(context, {.grid = {64, -4}}), InputError);
  EXPECT_THROW(makeProjectedGrid(context, {.grid = {8, 8}, .projectorElevation = 0.0}), InputError);
  EXPECT_THROW(drawn(test::stillSea(), cameraAt({0, 0, 1}, 0.0, 0.0, 60.0, {0, 90})), InputError);
  EXPECT_THROW(drawn(test::stillSea(), cameraAt({0, 0, 1}, 0.0, 0.0, 60.0, {1 << 20, 90})),
               InputError);
}

}  // namespace
}  // namespace seaway::render
