#include "surface/disturbance/analytic/ripple_pool.h"

#include <gtest/gtest.h>

#include <cmath>

#include "surface/constants.h"
#include "surface/input_error.h"
#include "tests/support/allocation_counter.h"

namespace seaway {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
const RippleSource fish{.place = {5.0, 7.0}, .time = 2.0};

SurfaceSample sampled(const RippleSheet& sheet, glm::dvec2 point, double t) {
  SurfaceSample sample;
  sheet.addTo(std::span(&point, 1), t, std::span(&sample, 1), {});
  return sample;
}

TEST(RipplePool, IsStillAndHoldsNothingBeforeItsSourceStartsAndAfterItsEnd) {
  RipplePool pool(fish);
  for (const double t : {0.0, 2.0, fish.end() + 1.0}) {
    pool.advance(t);
    EXPECT_EQ(pool.sheet(), nullptr) << t;
    EXPECT_EQ(pool.memoryBytes(), 0u);
  }
}

TEST(RipplePool, RingsRunOutRoundlyAtTheirSpeed) {
  RipplePool pool(fish);
  pool.advance(2.0 + 4.0);
  const auto sheet = pool.sheet();
  // Peaks pass a ring's points together, a wavelength a period apart.
  const double t = 6.005;
  double along = 0.0, across = 0.0, apart = 0.0, sum = 0.0;
  for (double r = 1.5; r < 4.0; r += 0.05) {
    const double east = sampled(*sheet, fish.place + glm::dvec2(r, 0.0), t).height;
    const double slant = sampled(*sheet, fish.place + glm::dvec2(r, r) * std::sqrt(0.5), t).height;
    const double next =
        sampled(*sheet, fish.place + glm::dvec2(r + fish.wavelength, 0.0), t).height;
    along += east * slant, across += east * east, sum += slant * slant;
    apart += east * next;
  }
  EXPECT_GT(along / std::sqrt(across * sum), 0.98);
  // A period's decay, and 1/√r over a wavelength.
  EXPECT_NEAR(apart / across, std::exp(-0.8 * RippleSource::decay) * std::sqrt(2.5 / 3.5), 0.15);
}

TEST(RipplePool, SourceMovesAsHighAsItIsTold) {
  RipplePool pool(fish);
  double highest = 0.0;
  for (double t = 4.0; t < 8.0; t += 0.03) {
    pool.advance(t);
    highest = std::max(highest, sampled(*pool.sheet(), fish.place, t).height);
  }
  // The spline smooths a fifth of a wavelength by a tenth.
  EXPECT_NEAR(highest, fish.height, 0.15 * fish.height);
}

TEST(RipplePool, TheSameLifeGivesTheSameBitsHoweverItIsStepped) {
  RipplePool often(fish), once(fish), back(fish);
  for (double t = 2.0; t < 6.0; t += 0.013) often.advance(t);
  often.advance(6.0);
  once.advance(6.0);
  back.advance(9.0);
  back.advance(6.0);
  for (double r = 0.0; r < 9.0; r += 0.3) {
    const glm::dvec2 point = fish.place + glm::dvec2(r, -0.4 * r);
    EXPECT_EQ(sampled(*often.sheet(), point, 6.0).height,
              sampled(*once.sheet(), point, 6.0).height);
    EXPECT_EQ(sampled(*back.sheet(), point, 6.0).height, sampled(*once.sheet(), point, 6.0).height);
  }
}

TEST(RipplePool, RipplesDieAwayAndLeaveThroughTheBorder) {
  RipplePool pool(fish);
  pool.advance(12.0);
  const double driven = pool.energy();
  pool.advance(fish.end() - 0.01);
  EXPECT_LT(pool.energy(), std::exp(-2.0 * RippleSource::lingering * RippleSource::decay) * driven);
}

TEST(RipplePool, SlopeAndRateAreTheHeightsDerivatives) {
  RipplePool pool(fish);
  pool.advance(6.0);
  const auto sheet = pool.sheet();
  const double t = 6.008, step = 1e-3;
  for (double r = 0.4; r < 8.0; r += 0.31) {
    const glm::dvec2 p = fish.place + glm::dvec2(r, 0.3 * r);
    const SurfaceSample sample = sampled(*sheet, p, t);
    const auto height = [&](double dx, double dy, double dt) {
      return sampled(*sheet, p + glm::dvec2(dx, dy), t + dt).height;
    };
    // Float heights over the step: 5e-9/1e-3; third derivatives of 5 cm, 1 m: 12 step².
    EXPECT_NEAR(sample.slope.x, (height(step, 0, 0) - height(-step, 0, 0)) / (2 * step), 5e-5);
    EXPECT_NEAR(sample.slope.y, (height(0, step, 0) - height(0, -step, 0)) / (2 * step), 5e-5);
    EXPECT_NEAR(sample.verticalVelocity, (height(0, 0, step) - height(0, 0, -step)) / (2 * step),
                5e-5);
  }
}

TEST(RipplePool, SamplingAllocatesNothing) {
  RipplePool pool(fish);
  pool.advance(6.0);
  const auto sheet = pool.sheet();
  const auto before = test_support::allocationCount();
  sampled(*sheet, fish.place, 6.0);
  EXPECT_EQ(test_support::allocationCount(), before);
}

TEST(RipplePoolHard, PointsOutsideAndNotFiniteAreStill) {
  RipplePool pool(fish);
  pool.advance(6.0);
  const auto sheet = pool.sheet();
  for (const glm::dvec2 point : {glm::dvec2(nan, 0.0), {1e300, 0.0}, {5.0, 40.0}}) {
    EXPECT_EQ(sampled(*sheet, point, 6.0).height, 0.0);
  }
  for (const double t : {nan, 0.0, 1e9}) EXPECT_EQ(sampled(*sheet, fish.place, t).height, 0.0);
}

TEST(RipplePoolHard, SourcesThatCannotBeAreRefused) {
  const auto refused = [](auto change) {
    RippleSource bad = fish;
    change(bad);
    EXPECT_THROW(RipplePool{bad}, InputError);
  };
  for (const double value : {nan, -1.0, 1e6}) {
    refused([&](RippleSource& s) { s.height = value; });
    refused([&](RippleSource& s) { s.duration = value; });
    refused([&](RippleSource& s) { s.period = value; });
    refused([&](RippleSource& s) { s.wavelength = value; });
    refused([&](RippleSource& s) { s.side = value; });
  }
  refused([&](RippleSource& s) { s.time = nan; });
  refused([&](RippleSource& s) { s.period = 0.2, s.wavelength = 1.0; });  // 5 m/s in cells of 0.1 m
}

TEST(RipplePoolHard, ALifeOfNoLengthStirsNothing) {
  RippleSource none = fish;
  none.duration = 0.0;
  RipplePool pool(none);
  pool.advance(3.0);
  EXPECT_EQ(pool.energy(), 0.0);
}

}  // namespace
}  // namespace seaway
