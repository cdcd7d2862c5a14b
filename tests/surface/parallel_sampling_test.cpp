#include "surface/parallel_sampling.h"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <cstring>
#include <vector>

#include "surface/fit/octave_fit.h"
#include "surface/spectra/families.h"
#include "tests/support/random_points.h"

namespace seaway {
namespace {

TEST(ParallelSampling, GivesTheSameBitsForAnyNumberOfThreads) {
  const WaterSurface water(WaveField(fitGroupOctaves(jonswap({1.12, 5.6, 3.3})).octaves));
  const SurfaceAtTime now = water.at(5.0);
  for (const std::size_t count : {0u, 1u, 2048u, 2049u, 50001u}) {
    const auto points = test_support::randomPoints(count, 5e3);
    std::vector<SurfaceSample> alone(count), together(count);
    now.sample(points, alone);
    for (const int threads : {1, 2, 5}) {
      std::fill(together.begin(), together.end(), SurfaceSample{});
      tbb::task_arena(threads).execute([&] { sampleInParallel(now, points, together); });
      if (count == 0) continue;
      EXPECT_EQ(std::memcmp(alone.data(), together.data(), count * sizeof(SurfaceSample)), 0);
    }
  }
}

TEST(ParallelSampling, FillsOnlyTheArraysAskedFor) {
  const WaterSurface water(WaveField(fitGroupOctaves(jonswap({1.12, 5.6, 3.3})).octaves));
  const SurfaceAtTime now = water.at(5.0);
  std::vector<double> x, y;
  for (const glm::dvec2& point : test_support::randomPoints(10000, 5e3)) {
    x.push_back(point.x), y.push_back(point.y);
  }
  std::vector<float> height(x.size()), slopeX(x.size());
  sampleInParallel(now.waves(), x, y,
                   {.height = height, .slopeX = slopeX, .slopeY = {}, .rate = {}});
  for (std::size_t i = 0; i < x.size(); ++i) {
    const SurfaceSample sample = now.sample({x[i], y[i]});
    ASSERT_EQ(height[i], static_cast<float>(sample.height));
    ASSERT_EQ(slopeX[i], static_cast<float>(sample.slope.x));
  }
}

}  // namespace
}  // namespace seaway
