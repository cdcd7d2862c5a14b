#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "sim_bridge/cost/rivals/cached_octaves.h"
#include "sim_bridge/cost/rivals/fft_tile.h"
#include "sim_bridge/cost/rivals/seas.h"
#include "sim_bridge/cost/rivals/sine_sum.h"
#include "surface/field/kernels/field_blocks.h"

/// The rivals are what they claim to be.
namespace seaway::rivals {
namespace {

constexpr JonswapParameters sea{1.12, 5.6, 3.3};
const FrequencySpectrum target = jonswap(sea);

struct Points {
  explicit Points(std::size_t count, double reach = 1e3) : x(count), y(count) {
    std::mt19937_64 random(2);
    std::uniform_real_distribution<double> uniform(-reach, reach);
    for (std::size_t i = 0; i < count; ++i) x[i] = uniform(random), y[i] = uniform(random);
  }
  std::vector<double> x, y;
};

TEST(SineSum, EqualsTheSumOfStandardCosinesOnEveryInstructionSet) {
  const auto components = sineComponents(target, 50);
  SineSum sum(components);
  sum.prepare(17.0);
  const Points points(300);
  std::vector<float> height(300), slopeX(300), slopeY(300), rate(300);
  for (const char* isa : {"AVX3", "AVX2", "SSE4"}) {
    if (!forceKernelTarget(isa)) continue;
    sum.sample(points.x, points.y, {height, slopeX, slopeY, rate});
    for (std::size_t i = 0; i < 300; ++i) {
      const glm::dvec2 p(points.x[i], points.y[i]);
      // Polynomial 5e-7 of each amplitude; central differences of 1e-4.
      EXPECT_NEAR(height[i], sineSumHeight(components, p, 17.0), 2e-6);
      const double h = 1e-4;
      const auto at = [&](double dx, double dy, double dt) {
        return sineSumHeight(components, p + glm::dvec2(dx, dy), 17.0 + dt);
      };
      EXPECT_NEAR(slopeX[i], (at(h, 0, 0) - at(-h, 0, 0)) / (2 * h), 2e-6);
      EXPECT_NEAR(slopeY[i], (at(0, h, 0) - at(0, -h, 0)) / (2 * h), 2e-6);
      EXPECT_NEAR(rate[i], (at(0, 0, h) - at(0, 0, -h)) / (2 * h), 2e-6);
    }
  }
  forceKernelTarget("");
}

TEST(SineSum, ComponentsHoldTheTargetsVariance) {
  double variance = 0.0;
  for (const SineComponent& c : sineComponents(target, 200)) {
    variance += 0.5 * c.amplitude * c.amplitude;
  }
  EXPECT_NEAR(4.0 * std::sqrt(variance), 1.12, 1e-3);
  EXPECT_LT(sineResidual(target, 1000), sineResidual(target, 50));
}

TEST(FftTile, NodesEqualTheDirectFourierSum) {
  FftTile tile(target, 32, 256.0);
  tile.step(3.0);
  const double step = 256.0 / 32.0, h = 1e-3;
  for (std::uint32_t n = 0; n < 32; ++n) {
    const std::uint32_t j = (7 * n + 3) % 32;
    const glm::dvec2 p(n * step, j * step);
    const Texel& node = tile.node(n, j);
    // Float FFT of 32² terms; differences of 1e-3.
    EXPECT_NEAR(node.height, tile.exactHeight(p, 3.0), 1e-6);
    const double right = tile.exactHeight(p + glm::dvec2(h, 0), 3.0);
    EXPECT_NEAR(node.slopeX, (right - tile.exactHeight(p - glm::dvec2(h, 0), 3.0)) / (2 * h), 1e-6);
    const double above = tile.exactHeight(p + glm::dvec2(0, h), 3.0);
    EXPECT_NEAR(node.slopeY, (above - tile.exactHeight(p - glm::dvec2(0, h), 3.0)) / (2 * h), 1e-6);
    const double later = tile.exactHeight(p, 3.0 + h);
    EXPECT_NEAR(node.rate, (later - tile.exactHeight(p, 3.0 - h)) / (2 * h), 1e-6);
  }
}

TEST(FftTile, HasTheTargetsWaveHeight) {
  FftTile tile(target, 256, 256.0);
  tile.step(1.0);
  double sum = 0.0;
  for (std::uint32_t n = 0; n < 256 * 256; ++n) {
    sum += std::pow(tile.node(n % 256, n / 256).height, 2);
  }
  // Parseval up to beats between k and −k, which the directional distribution leaves weak.
  EXPECT_NEAR(4.0 * std::sqrt(sum / (256.0 * 256.0)), 1.12, 0.01);
}

TEST(FftTile, LookUpsGoThroughNodesAndRepeatAfterATile) {
  FftTile tile(target, 64, 256.0);
  tile.step(3.0);
  for (const Interpolation interpolation : {Interpolation::bilinear, Interpolation::cubic}) {
    std::vector<double> x, y;
    for (int n = 0; n < 300; ++n) {
      x.push_back((n % 64 - 64) * 4.0);
      y.push_back((n % 50 + 64) * 4.0);
    }
    std::vector<Texel> out(x.size());
    tile.sample(x, y, interpolation, out);
    for (std::uint32_t n = 0; n < 300; ++n) {
      EXPECT_NEAR(out[n].height, tile.node(n % 64, n % 50).height, 1e-6);
      EXPECT_NEAR(out[n].rate, tile.node(n % 64, n % 50).rate, 1e-6);
    }
  }
}

TEST(FftTile, CubicLookUpsAreCloserToTheFourierSumThanBilinearOnes) {
  FftTile tile(target, 64, 128.0);
  tile.step(3.0);
  const Points points(200);
  double error[2] = {};
  for (const Interpolation interpolation : {Interpolation::bilinear, Interpolation::cubic}) {
    std::vector<Texel> out(200);
    tile.sample(points.x, points.y, interpolation, out);
    for (std::size_t i = 0; i < 200; ++i) {
      error[static_cast<int>(interpolation)] +=
          std::pow(out[i].height - tile.exactHeight({points.x[i], points.y[i]}, 3.0), 2);
    }
  }
  EXPECT_LT(error[1], 0.5 * error[0]);
  EXPECT_LT(std::sqrt(error[0] / 200.0), 0.28 / 4.0);
}

TEST(CachedOctaves, TexelsEqualTheirOctaves) {
  CachedOctaves cached(halvingPerlinOctaves(sea).octaves);
  cached.step(7.3);
  for (const std::size_t texture : {0u, 1u}) {
    for (std::uint32_t n = 0; n < 40; ++n) {
      const std::uint32_t i = (37 * n) % 256, j = (91 * n + 5) % 256;
      const glm::dvec2 centre = cached.texelCentre(texture, i, j);
      const auto at = [&](double dx, double dt) {
        const glm::dvec2 point = centre + glm::dvec2(dx, 0.0);
        return cached.exactHeights(texture, {&point, 1}, 7.3 + dt)[0];
      };
      EXPECT_NEAR(cached.texel(texture, i, j).height, at(0.0, 0.0), 1e-6);
      const double h = 1e-3;  // the shortest lattice is 0.2 m; gradients are floats
      EXPECT_NEAR(cached.texel(texture, i, j).slopeX, (at(h, 0.0) - at(-h, 0.0)) / (2 * h), 1e-4);
      EXPECT_NEAR(cached.texel(texture, i, j).rate, (at(0.0, h) - at(0.0, -h)) / (2 * h), 1e-3);
    }
  }
}

TEST(CachedOctaves, LatticesHalveAndLookUpsAddBothTextures) {
  const auto octaves = halvingPerlinOctaves(sea).octaves;
  ASSERT_EQ(octaves.size(), 8u);
  for (std::size_t i = 1; i < 8; ++i) {
    EXPECT_NEAR(octaves[i].latticeSize, 0.5 * octaves[i - 1].latticeSize, 1e-9);
  }
  const CachedOctaves cached(octaves);
  const glm::dvec2 centre = cached.texelCentre(0, 3, 9);
  const std::vector<double> x{centre.x}, y{centre.y};
  std::vector<Texel> out(1);
  cached.sample(x, y, Interpolation::cubic, 0.0, out);
  // The second texture's texels are 16 times smaller: its cubic look-up errs by part of its waves.
  const double second = std::hypot(octaves[4].standardDeviation, octaves[5].standardDeviation);
  EXPECT_NEAR(out[0].height, cached.exactHeights({&centre, 1}, 0.0)[0], second);
}

}  // namespace
}  // namespace seaway::rivals
