#include "surface/spectra/directional_spread.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "surface/constants.h"

namespace seaway {
namespace {

TEST(DirectionalSpread, QuantilesHaveTheFirstMomentOfTheSpreadingFunction) {
  // r1 = s/(s + 1) (Kuik, van Vledder & Holthuijsen 1988); midpoint sum over 400 quantiles.
  for (const double exponent : {0.5, 2.0, 10.0, 75.0}) {
    double cosine = 0.0;
    for (int i = 0; i < 400; ++i) cosine += std::cos(spreadQuantile(exponent, (i + 0.5) / 400.0));
    EXPECT_NEAR(cosine / 400.0, exponent / (exponent + 1.0), 2e-3) << exponent;
  }
}

TEST(DirectionalSpread, IsSymmetricAboutTheMeanDirection) {
  EXPECT_NEAR(spreadQuantile(5.0, 0.5), 0.0, 1e-3);
  EXPECT_NEAR(spreadQuantile(5.0, 0.2), -spreadQuantile(5.0, 0.8), 1e-3);
}

TEST(DirectionalSpread, ExponentOneHalfAgreesWithItsClosedForm) {
  // s = ½: D = cos(θ/2)/4, distribution (1 + sin(θ/2))/2.
  const double theta = spreadQuantile(0.5, 0.3);
  EXPECT_NEAR((1.0 + std::sin(theta / 2.0)) / 2.0, 0.3, 1e-3);
}

TEST(DirectionalSpread, InfiniteExponentIsOneDirection) {
  EXPECT_EQ(spreadQuantile(std::numeric_limits<double>::infinity(), 0.9), 0.0);
}

TEST(DirectionalSpread, VanDerCorputStartsAtTheMiddleAndFillsTheGaps) {
  EXPECT_EQ(vanDerCorput(0), 0.5);
  EXPECT_EQ(vanDerCorput(1), 0.25);
  EXPECT_EQ(vanDerCorput(2), 0.75);
  EXPECT_EQ(vanDerCorput(3), 0.125);
}

}  // namespace
}  // namespace seaway
