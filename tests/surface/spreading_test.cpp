#include "surface/spectra/spreading.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "surface/angles.h"
#include "surface/input_error.h"
#include "surface/spectra/families.h"

namespace seaway {
namespace {

/// ∫ D cos nθ dθ over the circle: the rectangle rule is exact for what is smooth and periodic.
double circularMoment(const std::function<double(double)>& density, int n) {
  constexpr int count = 3600;
  double sum = 0.0;
  for (int i = 0; i < count; ++i) {
    const double angle = 2.0 * pi * i / count - pi;
    sum += density(angle) * std::cos(n * angle);
  }
  return sum * 2.0 * pi / count;
}

TEST(Spreading, CosinePowerHasItsClosedMoments) {
  for (const double s : {0.0, 0.5, 1.0, 10.0, 75.0, 1000.0}) {
    const auto density = [&](double angle) { return cosinePowerSpreading(angle, s); };
    EXPECT_NEAR(circularMoment(density, 0), 1.0, 1e-6) << s;
    EXPECT_NEAR(circularMoment(density, 1), s / (s + 1.0), 1e-6) << s;
    EXPECT_NEAR(circularMoment(density, 2), s * (s - 1.0) / ((s + 1.0) * (s + 2.0)), 1e-6) << s;
  }
}

TEST(Spreading, WrappedNormalHasItsClosedMoments) {
  for (const double sigma : {0.02, 0.3, 1.0, 2.0, pi}) {
    const auto density = [&](double angle) { return wrappedNormalSpreading(angle, sigma); };
    EXPECT_NEAR(circularMoment(density, 0), 1.0, 1e-9) << sigma;
    EXPECT_NEAR(circularMoment(density, 1), std::exp(-0.5 * sigma * sigma), 1e-9) << sigma;
    EXPECT_NEAR(circularMoment(density, 2), std::exp(-2.0 * sigma * sigma), 1e-9) << sigma;
  }
}

TEST(Spreading, MitsuyasusExponentIsHighestAtThePeak) {
  EXPECT_DOUBLE_EQ(mitsuyasuExponent(0.1, 0.1, 10.0), 10.0);
  EXPECT_NEAR(mitsuyasuExponent(0.05, 0.1, 10.0), 10.0 / 32.0, 1e-12);
  EXPECT_NEAR(mitsuyasuExponent(0.4, 0.1, 10.0), 10.0 / 32.0, 1e-12);
  // A fully developed sea, 2π f_p U/g = 0.877 (U at 10 m and 19.5 m taken alike): s_p = 16.
  EXPECT_NEAR(mitsuyasuPeakExponent(0.877 * standardGravity / (2.0 * pi * 10.0), 10.0),
              11.5 * std::pow(0.877, -2.5), 1e-9);
}

TEST(Spreading, AGridKeepsEnergyMeanDirectionAndSpread) {
  const FrequencySpectrum energy = jonswap({2.0, 8.0, 3.3}, 50);
  const double toward = towardFromCompassFrom(355.0);
  for (const double s : {0.5, 2.0, 10.0, 75.0}) {
    const DirectionalSpectrum spectrum = spreadByCosinePower(energy, toward, s);
    EXPECT_FALSE(spectrum.validate());
    EXPECT_EQ(spectrum.energy.density, energy.density);
    for (std::size_t f = 0; f < 50; ++f) {
      double sum = 0.0;
      for (std::size_t d = 0; d < 72; ++d) sum += spectrum.at(f, d) * 2.0 * pi / 72.0;
      EXPECT_NEAR(sum, energy.density[f], 1e-12);
      EXPECT_NEAR(spectrum.moments[f].r1(), s / (s + 1.0), 1e-3) << s;
      EXPECT_NEAR(std::remainder(spectrum.moments[f].meanDirection() - toward, 2.0 * pi), 0.0,
                  1e-3);
    }
  }
}

TEST(Spreading, AWrappedNormalGridHasItsMoments) {
  const FrequencySpectrum energy = jonswap({2.0, 8.0, 3.3}, 5);
  for (const double sigma : {0.1, 0.5, 1.5}) {
    const DirectionalSpectrum spectrum = spreadByWrappedNormal(energy, 1.0, sigma);
    EXPECT_NEAR(spectrum.moments[2].r1(), std::exp(-0.5 * sigma * sigma), 1e-3);
    EXPECT_NEAR(spectrum.moments[2].meanDirection(), 1.0, 1e-3);
  }
}

TEST(Spreading, MitsuyasuGridsAreNarrowestAtThePeak) {
  const FrequencySpectrum energy = jonswap({2.0, 8.0, 3.3}, 50);
  const DirectionalSpectrum spectrum = spreadByMitsuyasu(energy, 1.0, 1.0 / 8.0, 20.0);
  for (std::size_t f = 0; f < 50; ++f) {
    const double s = mitsuyasuExponent(energy.frequency[f], 1.0 / 8.0, 20.0);
    EXPECT_NEAR(spectrum.moments[f].r1(), s / (s + 1.0), 1e-3) << energy.frequency[f];
  }
}

TEST(Spreading, OneDirectionHasMomentsOfLengthOne) {
  const DirectionalSpectrum spectrum = unidirectional(jonswap({2.0, 8.0, 3.3}, 5), 2.0);
  EXPECT_FALSE(spectrum.validate());
  EXPECT_FALSE(spectrum.hasGrid());
  EXPECT_NEAR(spectrum.moments[3].r1(), 1.0, 1e-15);
  EXPECT_NEAR(spectrum.moments[3].meanDirection(), 2.0, 1e-15);
}

TEST(SpreadingHard, ASpreadNarrowerThanTheGridFallsOnItsNearestDirection) {
  const FrequencySpectrum energy = jonswap({2.0, 8.0, 3.3}, 5);
  for (const double toward : {0.1, 2.0 * pi / 24.0 * 0.4, -3.0}) {
    const DirectionalSpectrum spectrum = spreadByCosinePower(energy, toward, 1e6, 12);
    EXPECT_FALSE(spectrum.validate());
    const double off = std::remainder(spectrum.moments[2].meanDirection() - toward, 2.0 * pi);
    EXPECT_LE(std::abs(off), pi / 12.0);
    EXPECT_NEAR(spectrum.moments[2].r1(), 1.0, 1e-9);
  }
}

TEST(SpreadingHard, WhatIsOutOfRangeIsRefused) {
  const FrequencySpectrum energy = jonswap({2.0, 8.0, 3.3}, 5);
  EXPECT_THROW(spreadByCosinePower(energy, 0.0, -1.0), InputError);
  EXPECT_THROW(spreadByCosinePower(energy, 0.0, NAN), InputError);
  EXPECT_THROW(spreadByCosinePower(energy, NAN, 1.0), InputError);
  EXPECT_THROW(spreadByCosinePower(energy, 0.0, 1.0, 2), InputError);
  EXPECT_THROW(spreadByCosinePower({}, 0.0, 1.0), InputError);
  EXPECT_THROW(spreadByWrappedNormal(energy, 0.0, 0.0), InputError);
  EXPECT_THROW(spreadByMitsuyasu(energy, 0.0, 0.0, 10.0), InputError);
  EXPECT_THROW(unidirectional(energy, INFINITY), InputError);
}

}  // namespace
}  // namespace seaway
