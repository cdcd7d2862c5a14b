#include "surface/spectra/families.h"

#include <gtest/gtest.h>

#include <cmath>

#include "surface/input_error.h"

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
  // The band ends at 8 f_p: of m₂ ∝ ∫f⁻³ df it leaves out (8 f_p)⁻²/2 relative to about 1: under 1 %.
  EXPECT_NEAR(spectrum.zeroCrossingPeriod() / closed, 1.0, 0.01);
}

TEST(Families, GammaRaisesThePeakByItsOwnFactor) {
  EXPECT_NEAR(jonswapShape(0.1, 0.1, 3.3) / jonswapShape(0.1, 0.1, 1.0), 3.3, 1e-12);
}

TEST(Families, ParametersOutOfRangeAreRejectedByName) {
  for (const JonswapParameters& bad : {JonswapParameters{0.0, 6.0, 3.3}, JonswapParameters{1.0, -6.0, 3.3},
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
