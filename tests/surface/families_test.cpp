#include "surface/spectra/families.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "surface/constants.h"
#include "surface/input_error.h"
#include "surface/spectra/sea_states.h"
#include "surface/spectra/swell.h"

namespace seaway {
namespace {

TEST(Families, JonswapHasTheWaveHeightAndPeakAskedFor) {
  for (const double gamma : {1.0, 3.3, 7.0}) {
    const FrequencySpectrum spectrum = jonswap({2.5, 9.0, gamma});
    EXPECT_NEAR(spectrum.significantWaveHeight(), 2.5, 1e-12);
    // 600 points over 7.7 f_p are 0.013 f_p apart; the parabola is good to a quarter of that.
    EXPECT_NEAR(spectrum.peakPeriod(), 9.0, 0.0032 * 9.0);
  }
}

TEST(Families, PiersonMoskowitzMomentsFollowTheClosedForm) {
  // m_n of A f⁻⁵ exp(−B f⁻⁴): m₀ = A/(4B), m₂ = A√π/(4√B): T_m02 = T_p (4/5)^¼ … = 0.7104 T_p.
  const FrequencySpectrum spectrum = piersonMoskowitz(3.0, 10.0, 4000);
  const double closed = 10.0 * std::pow(5.0 / 4.0, -0.25) * std::pow(3.14159265358979, -0.25);
  // The band ends at 8 f_p: of m₂ ∝ ∫f⁻³ df it leaves out (8 f_p)⁻²/2 relative to about 1: under 1
  // %.
  EXPECT_NEAR(spectrum.zeroCrossingPeriod() / closed, 1.0, 0.01);
}

TEST(Families, GammaRaisesThePeakByItsOwnFactor) {
  EXPECT_NEAR(jonswapShape(0.1, 0.1, 3.3) / jonswapShape(0.1, 0.1, 1.0), 3.3, 1e-12);
}

TEST(Families, AWindMakesItsFullyDevelopedSea) {
  // REFERENCE: H_m0 = 0.21 U²/g, ω_p = 0.877 g/U, both rounded.
  for (const double wind : {5.0, 10.0, 20.0}) {
    const FrequencySpectrum spectrum = piersonMoskowitzOfWind(wind);
    const double hm0 = spectrum.significantWaveHeight();
    EXPECT_NEAR(hm0 / (0.21 * wind * wind / standardGravity), 1.0, 0.005);
    // As above: the parabola is good to a quarter of a step.
    EXPECT_NEAR(2.0 * pi / spectrum.peakPeriod() / (0.877 * standardGravity / wind), 1.0, 0.004);
    // Far above the peak S(ω) = α g² ω⁻⁵: in Hz α g² (2π)⁻⁴ f⁻⁵. The band's cut at 8 f_p scales the
    // rest up by 0.03 %, and exp(−β (g/(Uω))⁴) at 5 f_p is 0.998.
    const double f = 5.0 / spectrum.peakPeriod();
    const double tail =
        0.0081 * std::pow(standardGravity, 2) * std::pow(2.0 * pi, -4) * std::pow(f, -5);
    EXPECT_NEAR(spectrum.at(f) / tail, 1.0, 0.004);
  }
}

/// Kitaigorodskii's factor as it stands: φ = tanh²(kd)/(1 + 2kd/sinh 2kd), at k of the dispersion.
double exactFactor(double frequency, double depth) {
  const double wanted = std::pow(2.0 * pi * frequency, 2) * depth / standardGravity;
  double low = 0.0;
  double high = wanted + 5.0;
  for (int i = 0; i < 100; ++i) {
    const double kd = 0.5 * (low + high);
    (kd * std::tanh(kd) < wanted ? low : high) = kd;
  }
  return std::pow(std::tanh(low), 2) / (1.0 + 2.0 * low / std::sinh(2.0 * low));
}

TEST(Families, TheFiniteDepthFactorIsWithinFourPercentOfTheExactOne) {
  for (double f = 0.02; f < 1.0; f *= 1.05) {
    EXPECT_NEAR(finiteDepthFactor(f, 10.0), exactFactor(f, 10.0), 0.04) << f;
  }
  // Closed forms of the approximation, and its joints at ω_h = 1 and 2.
  const double one = 1.0 / (2.0 * pi * std::sqrt(10.0 / standardGravity));
  EXPECT_NEAR(finiteDepthFactor(0.5 * one, 10.0), 0.125, 1e-12);
  EXPECT_NEAR(finiteDepthFactor(one, 10.0), 0.5, 1e-12);
  EXPECT_NEAR(finiteDepthFactor(1.5 * one, 10.0), 0.875, 1e-12);
  EXPECT_EQ(finiteDepthFactor(2.0 * one, 10.0), 1.0);
}

TEST(Families, TmaIsJonswapInDeepWaterAndLosesItsLowFrequenciesInShallow) {
  const JonswapParameters sea{2.0, 8.0, 3.3};
  const FrequencySpectrum deep = jonswap(sea);
  const FrequencySpectrum infinite = tma(sea, std::numeric_limits<double>::infinity());
  const FrequencySpectrum shallow = tma(sea, 5.0);
  for (std::size_t i = 0; i < deep.density.size(); ++i) {
    EXPECT_NEAR(infinite.density[i], deep.density[i], 1e-12);
  }
  EXPECT_NEAR(shallow.significantWaveHeight(), 2.0, 1e-12);
  EXPECT_LT(shallow.zeroCrossingPeriod(), deep.zeroCrossingPeriod());
  const double ratio = shallow.at(0.2) / shallow.at(0.1);
  EXPECT_NEAR(ratio / (deep.at(0.2) / deep.at(0.1)),
              finiteDepthFactor(0.2, 5.0) / finiteDepthFactor(0.1, 5.0), 0.01);  // between bins
}

TEST(Families, SwellIsABellOfItsWidthAtItsPeak) {
  const FrequencySpectrum spectrum = gaussianSwell(1.5, 14.0, 0.006, 2001);
  EXPECT_NEAR(spectrum.significantWaveHeight(), 1.5, 1e-12);
  EXPECT_NEAR(spectrum.peakPeriod(), 14.0, 1e-6);
  const double mean = spectrum.moment(1) / spectrum.moment(0);
  EXPECT_NEAR(mean, 1.0 / 14.0, 1e-9);
  // Five widths hold all but 1.5e-5 of the second moment.
  const double variance = spectrum.moment(2) / spectrum.moment(0) - mean * mean;
  EXPECT_NEAR(std::sqrt(variance), 0.006, 0.006 * 1e-4);
  EXPECT_NEAR(spectrum.at(1.0 / 14.0), std::pow(1.5 / 4.0, 2) / (0.006 * std::sqrt(2.0 * pi)),
              1e-3);
}

TEST(Families, WideSwellStopsBeforeFrequencyZero) {
  const FrequencySpectrum spectrum = gaussianSwell(1.0, 10.0, 0.05);
  EXPECT_FALSE(spectrum.validate());
  EXPECT_NEAR(spectrum.significantWaveHeight(), 1.0, 1e-12);
}

TEST(SeaStates, HaveTheHeightsOfTheWmoTable) {
  constexpr double bounds[] = {0.0, 0.1, 0.5, 1.25, 2.5, 4.0, 6.0, 9.0, 14.0};
  for (const SeaState& state : seaStates()) {
    const auto code = static_cast<std::size_t>(state.code);
    EXPECT_EQ(&seaState(state.code), &state);
    if (code == 0) continue;
    EXPECT_EQ(state.lowestHeight, bounds[code - 1]);
    if (code < 9) {
      EXPECT_EQ(state.highestHeight, bounds[code]);
      EXPECT_DOUBLE_EQ(state.significantWaveHeight, 0.5 * (bounds[code - 1] + bounds[code]));
    }
    EXPECT_GE(state.peakPeriod, seaState(state.code - 1).peakPeriod);
    const FrequencySpectrum spectrum = seaStateSpectrum(state.code);
    EXPECT_NEAR(spectrum.significantWaveHeight(), state.significantWaveHeight, 1e-12);
    EXPECT_NEAR(spectrum.peakPeriod(), state.peakPeriod, 0.004 * state.peakPeriod);
  }
}

TEST(SeaStates, RippledCalmIsTheFullyDevelopedSeaOfItsHeight) {
  // H = 0.209 U²/g and T_p = 2πU/(0.877 g): T_p = 5.00 √H.
  const double wind = std::sqrt(0.05 * standardGravity / (2.0 * std::sqrt(0.0081 / 0.74)));
  EXPECT_NEAR(seaState(1).peakPeriod, piersonMoskowitzOfWind(wind).peakPeriod(), 0.01);
}

TEST(FamiliesHard, WhatHasNoSpectrumIsRefusedWithItsReason) {
  EXPECT_THROW(seaState(-1), InputError);
  EXPECT_THROW(seaState(10), InputError);
  EXPECT_THROW(seaStateSpectrum(0), InputError);
  EXPECT_THROW(piersonMoskowitzOfWind(0.0), InputError);
  EXPECT_THROW(piersonMoskowitzOfWind(NAN), InputError);
  EXPECT_THROW(tma({1.0, 8.0, 3.3}, 0.0), InputError);
  EXPECT_THROW(tma({1.0, 8.0, 3.3}, NAN), InputError);
  EXPECT_THROW(tma({1.0, 8.0, 0.9}, 10.0), InputError);
  EXPECT_THROW(gaussianSwell(1.0, 10.0, 0.0), InputError);
  EXPECT_THROW(gaussianSwell(1.0, 10.0, 0.051), InputError);
  EXPECT_THROW(jonswap({1.0, 8.0, 3.3}, 1), InputError);
}

TEST(FamiliesHard, RipplesAndThirtyMetresKeepTheirHeights) {
  for (const double hm0 : {1e-6, 30.0}) {
    EXPECT_NEAR(jonswap({hm0, 8.0, 3.3}).significantWaveHeight() / hm0, 1.0, 1e-12);
    EXPECT_NEAR(tma({hm0, 8.0, 3.3}, 1.0).significantWaveHeight() / hm0, 1.0, 1e-12);
    EXPECT_NEAR(gaussianSwell(hm0, 8.0, 0.01).significantWaveHeight() / hm0, 1.0, 1e-12);
  }
}

TEST(Families, ParametersOutOfRangeAreRejectedByName) {
  for (const JonswapParameters& bad :
       {JonswapParameters{0.0, 6.0, 3.3}, JonswapParameters{1.0, -6.0, 3.3},
        JonswapParameters{1.0, 6.0, 0.5}, JonswapParameters{NAN, 6.0, 3.3}}) {
    EXPECT_THROW(jonswap(bad), InputError);
  }
  try {
    jonswap({-1.0, 6.0, 3.3});
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "significant wave height -1 is not allowed; must be > 0 m");
  }
}

}  // namespace
}  // namespace seaway
