#include "surface/disturbance/analytic/surface_events.h"

#include <gtest/gtest.h>

#include <cmath>

#include "surface/constants.h"
#include "surface/input_error.h"
#include "tests/support/allocation_counter.h"
#include "tests/support/random_points.h"

namespace seaway {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
const Splash stone{.place = {10.0, -4.0}, .time = 3.0};

SampleOptions orbital() { return {.orbitalVelocity = true}; }

std::vector<SurfaceSample> sampled(const SurfaceEvents& events, std::vector<glm::dvec2> points,
                                   double t, const SampleOptions& options = {}) {
  std::vector<SurfaceSample> samples(points.size());
  for (SurfaceSample& sample : samples) sample.orbitalVelocity = glm::dvec3(0.0);
  events.addTo(points, t, samples, options);
  return samples;
}

TEST(SplashRings, DerivativesAreThoseOfTheHeight) {
  const SplashRings rings(stone);
  const double step = 1e-5;
  for (double r = 0.03; r < rings.radius(); r += 0.37) {
    for (double age = 0.02; age < rings.lifetime(); age += 0.11) {
      const SplashRings::Value value = rings.at(r, age);
      // Second derivatives are below I₀ k² ≈ 5: differences err by 5 step² and rounding by 1e-11.
      EXPECT_NEAR(value.byDistance,
                  (rings.at(r + step, age).height - rings.at(r - step, age).height) / (2 * step),
                  1e-6);
      EXPECT_NEAR(value.byTime,
                  (rings.at(r, age + step).height - rings.at(r, age - step).height) / (2 * step),
                  1e-6);
    }
  }
}

TEST(SplashRings, RiseFromStillWaterAndEndInIt) {
  const SplashRings rings(stone);
  double largest = 0.0;
  for (double r = 0.0; r < rings.radius(); r += 0.1) {
    EXPECT_EQ(rings.at(r, 0.0).height, 0.0);
    EXPECT_NEAR(rings.at(r, 1e-4).height, 0.0, 1e-6);
    EXPECT_NEAR(rings.at(r, rings.lifetime() - 1e-4).height, 0.0, 1e-6);
    EXPECT_EQ(rings.at(r, rings.lifetime() + 1e-9).height, 0.0);
    for (double age = 0.0; age < 9.0; age += 0.05) {
      largest = std::max(largest, std::abs(rings.at(r, age).height));
    }
  }
  EXPECT_NEAR(rings.at(rings.radius() - 1e-4, 1.0).height, 0.0, 1e-6);
  EXPECT_LE(largest, stone.height);
  EXPECT_GT(largest, 0.3 * stone.height);
}

TEST(SplashRings, NoRingIsFartherThanItsPhaseSpeedBroughtIt) {
  const SplashRings rings(stone);
  const double speed = rings.angularFrequency() / rings.waveNumber();
  for (const double age : {0.3, 1.0, 2.0}) {
    const double front = speed * age + 0.5 * stone.wavelength;
    EXPECT_EQ(rings.at(front + 1e-9, age).height, 0.0);
    double before = 0.0;
    for (double r = 0.0; r < front; r += 0.05) before += std::abs(rings.at(r, age).height);
    EXPECT_GT(before, 0.0);
  }
}

TEST(SplashRings, KeepTheDispersionRelation) {
  const SplashRings deep(stone), shallow(stone, {}, 0.2);
  const double k = 2.0 * pi / stone.wavelength;
  EXPECT_DOUBLE_EQ(deep.angularFrequency(), std::sqrt(standardGravity * k));
  EXPECT_NEAR(shallow.angularFrequency(), std::sqrt(standardGravity * k * std::tanh(0.2 * k)),
              1e-12);
}

TEST(SurfaceEvents, WithoutEventsNothingIsAddedOrAllocated) {
  const auto before = test_support::allocationCount();
  const SurfaceEvents events({}, {}, {});
  EXPECT_TRUE(events.empty());
  EXPECT_EQ(events.memoryBytes(), 0u);
  SurfaceSample sample;
  const glm::dvec2 point(1.0, 2.0);
  events.addTo(std::span(&point, 1), 3.0, std::span(&sample, 1), {});
  EXPECT_EQ(sample.height, 0.0);
  EXPECT_EQ(test_support::allocationCount(), before);
}

TEST(SurfaceEvents, SplashesAddUpWhereverTheyAreAndWhateverTheBatch) {
  Splash other = stone;
  other.place.x += 2.0, other.time -= 0.4;
  const auto points = test_support::randomPoints(700, 15.0);
  const auto both = sampled(SurfaceEvents({stone, other}, {}, {}), points, 4.0, orbital());
  const auto first = sampled(SurfaceEvents({stone}, {}, {}), points, 4.0, orbital());
  const auto second = sampled(SurfaceEvents({other}, {}, {}), points, 4.0, orbital());
  for (std::size_t i = 0; i < points.size(); ++i) {
    // In another order: rounding alone.
    EXPECT_NEAR(both[i].height, first[i].height + second[i].height, 1e-15);
    EXPECT_NEAR(both[i].orbitalVelocity.x, first[i].orbitalVelocity.x + second[i].orbitalVelocity.x,
                1e-14);
    const auto alone = sampled(SurfaceEvents({stone, other}, {}, {}), {points[i]}, 4.0, orbital());
    EXPECT_EQ(alone[0].height, both[i].height);
    EXPECT_EQ(alone[0].slope, both[i].slope);
    EXPECT_EQ(alone[0].orbitalVelocity, both[i].orbitalVelocity);
  }
}

TEST(SurfaceEvents, ArraysAndSamplesAgreeAndShortRingsFadeFromCoarseGrids) {
  const SurfaceEvents events({stone}, {}, {.current = {0.4, 0.1}});
  const auto points = test_support::randomPoints(300, 15.0);
  const auto samples = sampled(events, points, 4.0);
  std::vector<double> x, y;
  for (const glm::dvec2 point : points) x.push_back(point.x), y.push_back(point.y);
  std::vector<float> height(300), slopeX(300), slopeY(300), rate(300), none(300);
  events.addSplashes(x, y, 4.0, 0.5, {height, slopeX, slopeY, rate});
  events.addSplashes(x, y, 4.0, 2.0 * stone.wavelength, {none, {}, {}, {}});
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_FLOAT_EQ(height[i], static_cast<float>(samples[i].height));
    EXPECT_FLOAT_EQ(slopeX[i], static_cast<float>(samples[i].slope.x));
    EXPECT_FLOAT_EQ(slopeY[i], static_cast<float>(samples[i].slope.y));
    EXPECT_FLOAT_EQ(rate[i], static_cast<float>(samples[i].verticalVelocity));
    EXPECT_EQ(none[i], 0.0f);
  }
}

TEST(SurfaceEvents, BeforeAndAfterItsLifeASplashIsNotThere) {
  const SurfaceEvents events({stone}, {}, {});
  const double end = events.splashes()[0].end();
  for (const double t : {-1e9, 0.0, 3.0, end, end + 1.0, 1e9}) {
    EXPECT_EQ(sampled(events, {stone.place}, t)[0].height, 0.0) << t;
    EXPECT_EQ(events.heightBound(t), 0.0);
  }
  EXPECT_NE(sampled(events, {stone.place}, 3.5)[0].height, 0.0);
  EXPECT_GE(events.heightBound(3.5), std::abs(sampled(events, {stone.place}, 3.5)[0].height));
}

TEST(SurfaceEvents, ASplashDriftsWithTheCurrent) {
  const SurfaceEvents still({stone}, {}, {}), moving({stone}, {}, {.current = {2.0, -1.0}});
  const auto a = sampled(still, {stone.place + glm::dvec2(1.0, 0.5)}, 4.5, orbital());
  const auto b = sampled(moving, {stone.place + glm::dvec2(1.0 + 3.0, 0.5 - 1.5)}, 4.5, orbital());
  EXPECT_NEAR(a[0].height, b[0].height, 1e-12);
  EXPECT_NEAR(b[0].verticalVelocity,
              a[0].verticalVelocity - 2.0 * a[0].slope.x + 1.0 * a[0].slope.y, 1e-12);
  EXPECT_NEAR(a[0].orbitalVelocity.z, b[0].orbitalVelocity.z, 1e-12);
}

TEST(SurfaceEvents, SamplingAllocatesNothing) {
  const SurfaceEvents events({stone, stone}, Rain::ofRate(20.0, 3), {});
  const auto points = test_support::randomPoints(600, 15.0);
  std::vector<SurfaceSample> samples(points.size());
  const auto before = test_support::allocationCount();
  events.addTo(points, 4.0, samples, orbital());
  EXPECT_EQ(test_support::allocationCount(), before);
}

TEST(SurfaceEventsHard, HugeCountsAreRefusedAndTheMostAllowedAreServed) {
  std::vector<Splash> splashes(SurfaceEvents::mostSplashes, stone);
  for (std::size_t i = 0; i < splashes.size(); ++i)
    splashes[i].time = 0.01 * static_cast<double>(i);
  const SurfaceEvents events(splashes, {}, {});
  EXPECT_TRUE(std::isfinite(sampled(events, {stone.place}, 20.0)[0].height));
  // Only those of the last lifetime are looked at.
  EXPECT_LE(events.splashesAbout(20.0).size(), 901u);
  splashes.push_back(stone);
  EXPECT_THROW(SurfaceEvents(splashes, {}, {}), InputError);
}

TEST(SurfaceEventsHard, SplashesThatCannotBeAreRefused) {
  const auto refused = [](auto change) {
    Splash bad = stone;
    change(bad);
    EXPECT_THROW(SurfaceEvents({bad}, {}, {}), InputError);
  };
  for (const double value : {nan, -1.0, 0.0, 1e9}) {
    if (value != 0.0) refused([&](Splash& s) { s.height = value; });
    refused([&](Splash& s) { s.duration = value; });
    refused([&](Splash& s) { s.wavelength = value; });
    refused([&](Splash& s) { s.reach = value; });
  }
  refused([&](Splash& s) { s.place.x = nan; });
  refused([&](Splash& s) { s.time = nan; });
}

TEST(SurfaceEventsHard, PlacesAndTimesThatAreNotFiniteAddNothing) {
  const SurfaceEvents events({stone}, Rain::ofRate(20.0, 3), {});
  for (const double bad : {nan, std::numeric_limits<double>::infinity()}) {
    EXPECT_EQ(sampled(events, {{bad, 0.0}}, 4.0)[0].height, 0.0);
    EXPECT_EQ(sampled(events, {stone.place}, bad)[0].height, 0.0);
  }
}

}  // namespace
}  // namespace seaway
