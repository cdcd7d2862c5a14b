#include "surface/disturbance/analytic/rain.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/random_points.h"

namespace seaway {
namespace {

TEST(Rain, DerivativesAreThoseOfTheHeight) {
  const Rain rain = Rain::ofRate(20.0, 5);
  const double step = 1e-3;
  for (const glm::dvec2 point : test_support::randomPoints(2000, 30.0)) {
    const double t = 12.3;
    const auto at = [&](double dx, double dy, double dt) {
      return static_cast<double>(rain.at(point + glm::dvec2(dx, dy), t + dt).height);
    };
    const Rain::Value value = rain.at(point, t);
    // Third derivatives are below 3 mm · k³ ≈ 4500 1/m² for each of two rings, float heights carry
    // 1e-10 m: 9000 step²/6 + 1e-10/step.
    EXPECT_NEAR(value.slopeX, (at(step, 0, 0) - at(-step, 0, 0)) / (2 * step), 2e-3);
    EXPECT_NEAR(value.slopeY, (at(0, step, 0) - at(0, -step, 0)) / (2 * step), 2e-3);
    EXPECT_NEAR(value.rate, (at(0, 0, step) - at(0, 0, -step)) / (2 * step), 2e-3);
  }
}

TEST(Rain, IsContinuousAcrossCellsAndFalls) {
  const Rain rain = Rain::ofRate(50.0, 5);
  for (int n = -40; n < 40; ++n) {
    const double edge = 0.5 * Rain::cell * n;
    for (double y = -3.0; y < 3.0; y += 0.1) {
      // The steepest slope is 0.5.
      EXPECT_NEAR(rain.at({edge - 1e-6, y}, 7.7).height, rain.at({edge + 1e-6, y}, 7.7).height,
                  2e-6);
    }
  }
  for (double t = 0.0; t < 4.0; t += 1.0 / 64.0) {
    EXPECT_NEAR(rain.at({0.3, 0.2}, t - 1e-6).height, rain.at({0.3, 0.2}, t + 1e-6).height, 1e-6);
  }
}

TEST(Rain, HarderRainHasMoreRings) {
  double before = -1.0;
  for (const double rate : {0.0, 1.0, 5.0, 20.0, 50.0}) {
    const Rain rain = Rain::ofRate(rate, 5);
    double sum = 0.0;
    for (const glm::dvec2 point : test_support::randomPoints(20000, 50.0)) {
      sum += std::pow(rain.at(point, 3.0).height, 2);
    }
    EXPECT_GT(sum, before) << rate;
    before = sum;
  }
  EXPECT_FALSE(Rain::ofRate(0.0, 5).falls());
}

TEST(Rain, MeanSquareSlopeIsAsStated) {
  for (const double rate : {5.0, 50.0}) {
    const Rain rain = Rain::ofRate(rate, 9);
    double sum = 0.0;
    constexpr std::size_t count = 200000;
    std::size_t n = 0;
    for (const glm::dvec2 point : test_support::randomPoints(count, 200.0)) {
      const Rain::Value value = rain.at(point, 0.01 * static_cast<double>(n++ % 997));
      sum += value.slopeX * value.slopeX + value.slopeY * value.slopeY;
    }
    // Rings cover a few per cent of the water each: 2e5 points tell their mean to 3 %.
    EXPECT_NEAR(sum / count / rain.meanSquareSlope(), 1.0, 0.05);
  }
}

TEST(Rain, RingsFallAnewElsewhere) {
  const Rain rain = Rain::ofRate(50.0, 5);
  const Rain::Drop first = rain.drop(4, -9, 2, 100.0),
                   next = rain.drop(4, -9, 2, 100.0 + Rain::lifetime);
  EXPECT_NE(first.x, next.x);
  EXPECT_NEAR(first.age, next.age, 1e-5);
}

TEST(RainHard, FarFromTheAnchorAndAfterDaysItIsAsElsewhere) {
  const Rain rain = Rain::ofRate(50.0, 5);
  double sum = 0.0;
  for (const glm::dvec2 point : test_support::randomPoints(20000, 50.0)) {
    sum += std::pow(rain.at(point + glm::dvec2(2e5, -3e7), 1e6).height, 2);
  }
  double near = 0.0;
  for (const glm::dvec2 point : test_support::randomPoints(20000, 50.0)) {
    near += std::pow(rain.at(point, 3.0).height, 2);
  }
  EXPECT_NEAR(sum / near, 1.0, 0.1);  // 2e4 points, half of them in a ring
}

}  // namespace
}  // namespace seaway
