#include "surface/fit/sea_parameters.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "surface/angles.h"
#include "surface/input_error.h"
#include "surface/spectra/families.h"

namespace seaway {
namespace {

constexpr double degrees = 16.0;

/// χ²₁₆/16, as the sum of squares of normals that a generator of fixed bits gives.
double scatter(std::mt19937_64& random) {
  double sum = 0.0;
  for (int i = 0; i < 8; ++i) {
    sum -= std::log((static_cast<double>(random() >> 11) + 0.5) * 0x1p-53) / 8.0;
  }
  return sum;
}

/// A JONSWAP sea on a buoy's 46 bins.
DirectionalSpectrum buoySea(const JonswapParameters& sea) {
  const double scale =
      jonswap(sea).at(1.0 / sea.peakPeriod) /
      jonswapShape(1.0 / sea.peakPeriod, 1.0 / sea.peakPeriod, sea.peakEnhancement);
  DirectionalSpectrum spectrum;
  for (int i = 0; i < 46; ++i) {
    const double f = 0.0325 + 0.01 * i;
    spectrum.energy.frequency.push_back(f);
    spectrum.energy.density.push_back(scale *
                                      jonswapShape(f, 1.0 / sea.peakPeriod, sea.peakEnhancement));
  }
  return spectrum;
}

TEST(SeaParameters, AreRecoveredFromSpectraThatScatterAsABuoysDo) {
  const DirectionalSpectrum truth = buoySea({2.0, 8.0, 3.3});
  std::mt19937_64 random(7);
  double height = 0.0, period = 0.0;
  int within = 0;
  constexpr int count = 500;
  for (int n = 0; n < count; ++n) {
    DirectionalSpectrum measured = truth;
    for (double& density : measured.energy.density) density *= scatter(random);
    const SeaParameters fit =
        fitSeaParameters(measured, {.degreesOfFreedom = degrees, .systems = 1});
    ASSERT_TRUE(fit.usable) << fit.message;
    const WaveSystem& sea = fit.systems[0];
    height += sea.significantWaveHeight.value / count;
    period += sea.peakPeriod.value / count;
    within += std::abs(sea.peakEnhancement.value - 3.3) <= sea.peakEnhancement.deviation ? 1 : 0;
  }
  EXPECT_NEAR(height / 2.0, 1.0, 0.01);
  EXPECT_NEAR(period / 8.0, 1.0, 0.01);
  // 68.3 % of 500 has a standard deviation of 2.1 %; γ's own distribution is skew.
  EXPECT_NEAR(within / static_cast<double>(count), 0.683, 0.065);
}

TEST(SeaParameters, AreExactWhereNothingScatters) {
  const SeaParameters fit = fitSeaParameters(buoySea({3.0, 9.0, 2.5}), {.systems = 1});
  ASSERT_TRUE(fit.usable);
  // The grid of the integral over the shape, 160 steps, against the family's 600 points.
  EXPECT_NEAR(fit.systems[0].significantWaveHeight.value, 3.0, 0.01);
  EXPECT_NEAR(fit.systems[0].peakPeriod.value, 9.0, 1e-3);
  EXPECT_NEAR(fit.systems[0].peakEnhancement.value, 2.5, 1e-2);
}

TEST(SeaParameters, ChoosesTwoSystemsOnlyWhereThereAreTwo) {
  const DirectionalSpectrum wind = buoySea({2.0, 5.0, 3.3}), swell = buoySea({1.5, 14.0, 5.0});
  DirectionalSpectrum both = wind;
  std::mt19937_64 random(3);
  for (std::size_t i = 0; i < both.energy.density.size(); ++i) {
    const double s = swell.energy.density[i], w = wind.energy.density[i];
    const double east = (s * 0.95 * std::cos(2.0) + w * 0.8 * std::cos(-1.0)) / (s + w);
    const double north = (s * 0.95 * std::sin(2.0) + w * 0.8 * std::sin(-1.0)) / (s + w);
    both.moments.push_back({east, north});
    both.energy.density[i] = (s + w) * scatter(random);
  }
  const SeaParameters two = fitSeaParameters(both, {.degreesOfFreedom = degrees});
  ASSERT_EQ(two.systems.size(), 2u);
  EXPECT_LT(two.aicOfTwo, two.aicOfOne);
  // Three standard deviations of what was stated.
  const auto near = [](const Estimate& estimate, double truth) {
    EXPECT_NEAR(estimate.value, truth, 3.0 * estimate.deviation);
  };
  near(two.systems[0].significantWaveHeight, 1.5);
  near(two.systems[0].peakPeriod, 14.0);
  near(two.systems[1].significantWaveHeight, 2.0);
  near(two.systems[1].peakPeriod, 5.0);
  EXPECT_NEAR(two.systems[0].toward.value, 2.0, 0.1);
  EXPECT_NEAR(two.systems[1].toward.value, -1.0, 0.1);
  // r₁ = s/(s + 1): 0.95 is s = 19, 0.8 is s = 4.
  EXPECT_NEAR(two.systems[1].spreadExponent.value, 4.0, 1.0);
  const SeaParameters one = fitSeaParameters(wind, {.degreesOfFreedom = degrees});
  EXPECT_EQ(one.systems.size(), 1u);
}

TEST(SeaParametersHard, BinsThatReadZeroAreLeftOutAndCounted) {
  DirectionalSpectrum sea = buoySea({2.0, 8.0, 3.3});
  for (std::size_t i = 0; i < 5; ++i) sea.energy.density[i] = 0.0;
  const SeaParameters fit = fitSeaParameters(sea, {.systems = 1});
  ASSERT_TRUE(fit.usable);
  EXPECT_EQ(fit.zeroBins, 5u);
  EXPECT_EQ(fit.bins, 41u);
  EXPECT_NEAR(fit.systems[0].significantWaveHeight.value, 2.0, 0.02);
}

TEST(SeaParametersHard, SpectraThatSayTooLittleAreNotUsable) {
  for (const std::vector<double>& density : {std::vector<double>{0.0, 0.0, 0.0, 0.0, 0.0},
                                             {0.0, 0.0, 1.0, 0.0, 0.0},
                                             {0.0, 1.0, 2.0, 1.0, 0.0}}) {
    DirectionalSpectrum sea;
    sea.energy = {{0.1, 0.2, 0.3, 0.4, 0.5}, density};
    const SeaParameters fit = fitSeaParameters(sea);
    EXPECT_FALSE(fit.usable);
    EXPECT_FALSE(fit.message.empty());
    EXPECT_TRUE(fit.systems.empty());
  }
}

TEST(SeaParametersHard, HeightsFromMicrometresToThirtyMetresAreFitted) {
  for (const double height : {1e-6, 30.0}) {
    const SeaParameters fit = fitSeaParameters(buoySea({height, 10.0, 3.3}), {.systems = 1});
    ASSERT_TRUE(fit.usable);
    EXPECT_NEAR(fit.systems[0].significantWaveHeight.value / height, 1.0, 0.01);
  }
}

TEST(SeaParametersHard, OptionsOutOfRangeAreRejected) {
  const DirectionalSpectrum sea = buoySea({2.0, 8.0, 3.3});
  EXPECT_THROW(fitSeaParameters(sea, {.degreesOfFreedom = 1.0}), InputError);
  EXPECT_THROW(fitSeaParameters(sea, {.systems = 3}), InputError);
  EXPECT_THROW(fitSeaParameters(sea, {.maxIterations = 0}), InputError);
}

}  // namespace
}  // namespace seaway
