#include "surface/field/group_spectrum.h"

#include <gtest/gtest.h>

#include "surface/field/octave.h"

namespace seaway {
namespace {

TEST(GroupSpectrum, HoldsTheWholeVarianceAndIsEven) {
  double sum = 0.0;
  for (double q = 5e-4; q < 5.0; q += 1e-3) sum += 2.0 * 1e-3 * groupEnvelopeDensity(q);
  EXPECT_NEAR(sum, 1.0, 2e-5);  // the stated tail beyond |q| = 4
  EXPECT_EQ(groupEnvelopeDensity(-0.3), groupEnvelopeDensity(0.3));
}

TEST(GroupSpectrum, IsHalfItsMaximumAtHalfTheStatedWidth) {
  EXPECT_NEAR(groupEnvelopeDensity(0.5 * groupBandCycles) / groupEnvelopeDensity(0.0), 0.5, 2e-3);
}

}  // namespace
}  // namespace seaway
