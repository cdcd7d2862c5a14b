#include "surface/curvature.h"

#include <gtest/gtest.h>

#include <cmath>

#include "surface/angles.h"

namespace seaway {
namespace {

TEST(Curvature, HorizonDistancesAgreeWithPublishedOnes) {
  // acos(R/(R + h)) for R = 6371 km, given to three or four digits.
  EXPECT_NEAR(horizonDistance(2.0), 5.05e3, 5.0);
  EXPECT_NEAR(horizonDistance(10.0), 11.3e3, 50.0);
  EXPECT_NEAR(horizonDistance(100.0), 35.7e3, 50.0);
  EXPECT_NEAR(horizonDistance(1000.0), 112.9e3, 50.0);
}

TEST(Curvature, HorizonDipIsThatOfTheSphereWithinATenthOfAPixelUpToThirtyKilometres) {
  const double tenthOfPixel = 0.1 * radiansFromDegrees(60.0) / 720.0;
  for (const double height : {0.1, 2.0, 10.0, 100.0, 1e3, 10e3, 30e3}) {
    // Steepest view that still touches: the tangent from (0, h) to −d²/2R.
    const double distance = horizonDistance(height);
    const double dip = std::atan2(height + seaDrop(distance), distance);
    const double sphere = std::acos(earthMeanRadius / (earthMeanRadius + height));
    EXPECT_NEAR(dip, sphere, tenthOfPixel) << height;
  }
}

TEST(Curvature, CrestsShowBeyondTheHorizonOfStillWater) {
  EXPECT_EQ(crestReach(10.0, 0.0), horizonDistance(10.0));
  EXPECT_NEAR(crestReach(10.0, 5.0), horizonDistance(10.0) + horizonDistance(5.0), 1e-9);
  EXPECT_EQ(horizonDistance(-3.0), 0.0);
}

}  // namespace
}  // namespace seaway
