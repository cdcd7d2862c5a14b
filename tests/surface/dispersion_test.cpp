#include "surface/dispersion.h"

#include <gtest/gtest.h>

#include <cmath>

#include "surface/constants.h"

namespace seaway {
namespace {

TEST(Dispersion, DeepWaterFollowsTheClosedForm) {
  const double omega = 2.0 * pi / 8.0;
  const double k = waveNumber(omega);
  EXPECT_DOUBLE_EQ(k, omega * omega / standardGravity);
  EXPECT_DOUBLE_EQ(groupSpeed(k), 0.5 * phaseSpeed(k));
}

TEST(Dispersion, WaveNumberInvertsAngularFrequencyAtAnyDepth) {
  for (const double depth : {0.5, 5.0, 50.0, 5000.0}) {
    for (const double omega : {0.05, 0.3, 1.0, 5.0, 20.0}) {
      const double k = waveNumber(omega, depth);
      // Newton stops at relative 1e-15; evaluation of tanh adds a few roundings.
      EXPECT_NEAR(angularFrequency(k, depth) / omega, 1.0, 1e-13) << depth << ' ' << omega;
    }
  }
}

TEST(Dispersion, ShallowWaterTravelsAtRootGd) {
  const double k = waveNumber(0.02, 1.0);
  // kd = 0.0064: phase and group speed differ from √(gd) by (kd)²/6 and (kd)²/2.
  EXPECT_NEAR(phaseSpeed(k, 1.0), std::sqrt(standardGravity), 3e-5);
  EXPECT_NEAR(groupSpeed(k, 1.0), std::sqrt(standardGravity), 1e-4);
}

TEST(Dispersion, GroupSpeedIsTheDerivativeOfFrequency) {
  for (const double depth : {2.0, 20.0, deepWater}) {
    const double k = 0.3, step = 1e-5;
    const double difference =
        (angularFrequency(k + step, depth) - angularFrequency(k - step, depth)) / (2 * step);
    EXPECT_NEAR(groupSpeed(k, depth), difference, 1e-8);  // step² times the third derivative
  }
}

TEST(DispersionHard, VeryDeepAndShortWavesDoNotOverflow) {
  EXPECT_TRUE(std::isfinite(groupSpeed(700.0, 1000.0)));
  EXPECT_DOUBLE_EQ(groupSpeed(700.0, 1000.0), groupSpeed(700.0));
}

}  // namespace
}  // namespace seaway
