#include "surface/spectra/two_peak_families.h"

#include <gtest/gtest.h>

#include <cmath>

#include "surface/constants.h"
#include "surface/input_error.h"
#include "surface/spectra/families.h"

namespace seaway {
namespace {

/// m₀ of a density by the trapezoidal rule, evenly in ln f, far beyond the bands of the spectra.
template <class Density>
double variance(const Density& density) {
  constexpr int count = 20000;
  double sum = 0.0;
  for (int i = 0; i <= count; ++i) {
    const double f = 0.001 * std::pow(1e6, static_cast<double>(i) / count);
    sum += (i == 0 || i == count ? 0.5 : 1.0) * density(f) * f;
  }
  return sum * std::log(1e6) / count;
}

TEST(OchiHubble, EachSystemHasItsHeightAndPeakExactly) {
  for (const double shape : {0.5, 1.0, 3.0, 10.0}) {
    const OchiHubblePart part{2.0, 8.0, shape};
    const double m0 = variance([&](double f) { return ochiHubbleDensity(f, part); });
    // f^−(4λ+1) cut at 1000 Hz leaves (ω_p/ω)^4λ out: 2e-8 at λ = 0.5.
    EXPECT_NEAR(4.0 * std::sqrt(m0), 2.0, 1e-5) << shape;
    const double peak = ochiHubbleDensity(1.0 / 8.0, part);
    EXPECT_GT(peak, ochiHubbleDensity(1.001 / 8.0, part));
    EXPECT_GT(peak, ochiHubbleDensity(0.999 / 8.0, part));
  }
}

TEST(OchiHubble, ShapeOneIsPiersonMoskowitz) {
  const FrequencySpectrum wide = piersonMoskowitz(2.0, 8.0, 4000);
  for (const double f : {0.09, 0.125, 0.2, 0.4}) {
    // The band of `wide` ends at 8 f_p and is scaled to the whole height: 0.03 %.
    EXPECT_NEAR(ochiHubbleDensity(f, {2.0, 8.0, 1.0}) / wide.at(f), 1.0, 1e-3);
  }
}

TEST(OchiHubble, TheMostProbableSeaHasThePublishedParameters) {
  // At H = 4 m by the paper's formulas: ω₁ = 0.5824, ω₂ = 0.9839 rad/s, λ₂ = 1.2018,
  // heights 3.36, 2.16.
  const FrequencySpectrum spectrum = ochiHubbleMostProbable(4.0, 4000);
  EXPECT_NEAR(spectrum.significantWaveHeight(), 4.0, 1e-12);
  const OchiHubblePart swell{3.36, 2.0 * pi / 0.582355, 3.0};
  const OchiHubblePart windSea{2.16, 2.0 * pi / 0.983893, 1.201754};
  const double whole = 16.0 / (3.36 * 3.36 + 2.16 * 2.16);
  for (const double f : {0.07, 0.0927, 0.12, 0.157, 0.25}) {
    const double published = ochiHubbleDensity(f, swell) + ochiHubbleDensity(f, windSea);
    // The band's end, and linear interpolation between its bins.
    EXPECT_NEAR(spectrum.at(f) / (published * whole), 1.0, 2e-3) << f;
  }
}

TEST(OchiHubble, SixParametersGiveTwoPeaks) {
  const FrequencySpectrum spectrum = ochiHubble({2.0, 14.0, 5.0}, {1.5, 5.0, 2.0});
  EXPECT_NEAR(spectrum.significantWaveHeight(), 2.5, 1e-12);
  EXPECT_GT(spectrum.at(1.0 / 14.0), 5.0 * spectrum.at(0.12));
  EXPECT_GT(spectrum.at(1.0 / 5.0), 3.0 * spectrum.at(0.12));
  EXPECT_NEAR(spectrum.peakPeriod(), 14.0, 0.1);
}

TEST(Torsethaugen, SystemsFollowThePublishedFormulas) {
  // Worked by hand from table 1 of the paper. H = 5 m: T_f = 6.6·5^⅓ = 11.2858 s.
  const TorsethaugenSystems wind = torsethaugenSystems(5.0, 9.0);
  EXPECT_TRUE(wind.windDominated);
  // ε = (11.2858 − 9)/(11.2858 − 2√5) = 0.33549; r = 0.7 + 0.3 e^−(ε/0.5)² = 0.89126
  EXPECT_NEAR(wind.primaryHeight, 5.0 * 0.89126, 5e-4);
  EXPECT_NEAR(wind.secondaryHeight, 5.0 * std::sqrt(1.0 - 0.89126 * 0.89126), 1e-3);
  EXPECT_NEAR(wind.secondaryPeriod, 13.2858, 1e-4);
  // γ = 35 (2π/g · 4.4563/81)^(6/7) = 1.9896
  EXPECT_NEAR(wind.peakEnhancement, 1.9896, 2e-4);

  const TorsethaugenSystems swell = torsethaugenSystems(2.0, 14.0);
  EXPECT_FALSE(swell.windDominated);
  // T_f = 8.31548; ε = (14 − T_f)/(25 − T_f) = 0.34071; r = 0.6 + 0.4 e^−(ε/0.3)² = 0.71013
  EXPECT_NEAR(swell.primaryHeight, 2.0 * 0.71013, 5e-4);
  EXPECT_NEAR(swell.secondaryHeight, 2.0 * std::sqrt(1.0 - 0.71013 * 0.71013), 1e-3);
  EXPECT_NEAR(swell.secondaryPeriod, 6.6 * std::cbrt(swell.secondaryHeight), 1e-9);
  // γ = 35 (2π/g · 2/T_f²)^(6/7) (1 + 6 ε) = 1.1466 · 3.0442
  EXPECT_NEAR(swell.peakEnhancement, 3.491, 2e-3);
}

TEST(Torsethaugen, HeightIsTheOneAskedForBeforeAnyScaling) {
  for (const auto& [hm0, tp] :
       {std::pair{2.0, 6.0}, std::pair{5.0, 9.0}, std::pair{5.0, 11.2}, std::pair{2.0, 14.0},
        std::pair{1.0, 18.0}, std::pair{10.0, 14.0}}) {
    const TorsethaugenSystems systems = torsethaugenSystems(hm0, tp);
    const double m0 = variance([&](double f) { return torsethaugenDensity(f, systems); });
    EXPECT_NEAR(4.0 * std::sqrt(m0) / hm0, 1.0, 0.03) << hm0 << ' ' << tp;
    const FrequencySpectrum spectrum = torsethaugen(hm0, tp);
    EXPECT_NEAR(spectrum.significantWaveHeight(), hm0, 1e-12);
    // 600 points in ln f are at most 1 % apart.
    EXPECT_NEAR(spectrum.peakPeriod() / tp, 1.0, 0.01) << hm0 << ' ' << tp;
  }
}

TEST(Torsethaugen, ASeaAtTheLimitHasOneSystem) {
  const double limit = 6.6 * std::cbrt(3.0);
  const TorsethaugenSystems systems = torsethaugenSystems(3.0, limit);
  EXPECT_NEAR(systems.primaryHeight, 3.0, 1e-12);
  EXPECT_NEAR(systems.secondaryHeight, 0.0, 1e-6);
  // Continuous from one side of the limit to the other.
  EXPECT_NEAR(torsethaugen(3.0, limit * 0.999).at(0.12) / torsethaugen(3.0, limit * 1.001).at(0.12),
              1.0, 0.02);
}

TEST(TwoPeakFamiliesHard, ExtremesStayFiniteOrAreRefused) {
  for (const double tp : {0.5, 1.0, 2.0, 24.0, 40.0}) {
    for (const double hm0 : {1e-6, 0.01, 1.0, 30.0, 100.0}) {
      EXPECT_FALSE(torsethaugen(hm0, tp).validate()) << hm0 << ' ' << tp;
    }
  }
  EXPECT_FALSE(ochiHubble({0.0, 14.0, 5.0}, {1.5, 5.0, 20.0}).validate());
  EXPECT_FALSE(ochiHubble({1e-6, 20.0, 0.1}, {30.0, 5.0, 20.0}).validate());
  EXPECT_THROW(ochiHubble({0.0, 14.0, 5.0}, {0.0, 5.0, 2.0}), InputError);
  EXPECT_THROW(ochiHubble({1.0, 14.0, 0.0}, {1.0, 5.0, 2.0}), InputError);
  EXPECT_THROW(ochiHubble({1.0, -14.0, 1.0}, {1.0, 5.0, 2.0}), InputError);
  EXPECT_THROW(ochiHubbleMostProbable(21.0), InputError);
  EXPECT_THROW(torsethaugen(0.0, 8.0), InputError);
  EXPECT_THROW(torsethaugen(1.0, NAN), InputError);
}

}  // namespace
}  // namespace seaway
