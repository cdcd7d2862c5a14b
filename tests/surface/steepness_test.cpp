#include "surface/spectra/steepness.h"

#include <gtest/gtest.h>

#include <cmath>

#include "surface/dispersion.h"
#include "surface/fit/octave_fit.h"
#include "surface/spectra/families.h"

namespace seaway {
namespace {

TEST(Steepness, MeanPeriodOfOctavesIsThatOfTheSpectrumTheyStandFor) {
  const FrequencySpectrum target = jonswap({2.0, 8.0, 3.3});
  const OctaveFit fit = fitGroupOctaves(target);
  // An octave counts at one frequency: what lies above it in its band is missed.
  EXPECT_NEAR(meanPeriod(fit.octaves, deepWater), fit.summary.tm02Target,
              0.05 * fit.summary.tm02Target);
}

TEST(Steepness, LimitsAreThoseOfDnvRpC205) {
  EXPECT_DOUBLE_EQ(limitingSteepness(3.0), 0.1);
  EXPECT_DOUBLE_EQ(limitingSteepness(6.0), 0.1);
  EXPECT_DOUBLE_EQ(limitingSteepness(12.0), 1.0 / 15.0);
  EXPECT_DOUBLE_EQ(limitingSteepness(20.0), 1.0 / 15.0);
  EXPECT_NEAR(limitingSteepness(9.0), 0.5 * (1.0 / 10.0 + 1.0 / 15.0), 1e-12);
  // H_m0 of a wave of 10 s that is one fifteenth as high as it is long in deep water.
  EXPECT_NEAR(averageSteepness(156.07 / 15.0, 10.0), 1.0 / 15.0, 1e-4);
}

TEST(Steepness, FlatWaterHasNoPeriodAndIsNotSteep) {
  EXPECT_TRUE(std::isnan(meanPeriod({}, deepWater)));
  EXPECT_FALSE(averageSteepness(0.0, meanPeriod({}, deepWater)) > 0.1);
}

}  // namespace
}  // namespace seaway
