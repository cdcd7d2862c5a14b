#include <gtest/gtest.h>

#include <cmath>

#include "surface/constants.h"
#include "surface/disturbance/wake_system.h"
#include "surface/water_kinematics.h"
#include "surface/water_surface.h"
#include "tests/support/allocation_counter.h"

namespace seaway {
namespace {

WaveField sea() {
  Octave octave;
  octave.kind = OctaveKind::regular;
  octave.standardDeviation = 0.2;
  octave.waveNumber = 0.2;
  return WaveField({octave});
}

/// A launch that has sailed ten seconds east, felt by someone beside its course.
struct Wake {
  Wake() : vessel(system.addVessel(HullFootprint::wigley(12.0, 3.5, 0.8))) {
    for (int i = 0; i <= 100; ++i) {
      system.record(vessel, {0.1 * i, {0.5 * i, 0.0}, 0.0, 1.0});
    }
    system.advance(10.0, std::vector<WakeListener>{{{40.0, 20.0}, 5.0, 0}});
  }
  WakeSystem system;
  std::uint32_t vessel;
};

const std::vector<glm::dvec2> points{{40.0, 1.0}, {35.0, 6.0}, {30.0, -9.0}, {5000.0, 0.0}};

TEST(Composition, WavesAndWakeAddUpInEveryQuantity) {
  Wake wake;
  WaterSurface water(sea());
  const SampleOptions options{.orbitalVelocity = true};
  std::vector<SurfaceSample> waves(points.size()), both(points.size()), alone(points.size());
  water.sample(points, 10.0, waves, options);
  water.setDisturbances(wake.system.feed());
  water.sample(points, 10.0, both, options);
  for (SurfaceSample& sample : alone) sample.orbitalVelocity = glm::dvec3(0.0);
  wake.system.latest()->addTo(points, 10.0, alone, options);
  const SurfaceAtTime now = water.at(10.0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(both[i].height, waves[i].height + alone[i].height);
    EXPECT_EQ(both[i].slope, waves[i].slope + alone[i].slope);
    EXPECT_EQ(both[i].verticalVelocity, waves[i].verticalVelocity + alone[i].verticalVelocity);
    EXPECT_EQ(both[i].orbitalVelocity, waves[i].orbitalVelocity + alone[i].orbitalVelocity);
    const SurfaceSample single = now.sample(points[i], options);
    EXPECT_EQ(single.height, both[i].height);
    EXPECT_EQ(single.orbitalVelocity, both[i].orbitalVelocity);
  }
  EXPECT_GT(std::abs(alone[0].height), 0.01);
  EXPECT_EQ(alone[3].height, 0.0);
  EXPECT_GT(now.heightBound(), water.waves().heightBound());
}

TEST(Composition, TheRateIsTheHeightsDerivative) {
  Wake wake;
  const auto state = wake.system.latest();
  const double step = 0.01;
  for (const glm::dvec2 point : points) {
    SurfaceSample before, now, after;
    state->addTo(std::span(&point, 1), 10.02 - step, std::span(&before, 1), {});
    state->addTo(std::span(&point, 1), 10.02, std::span(&now, 1), {});
    state->addTo(std::span(&point, 1), 10.02 + step, std::span(&after, 1), {});
    // Third derivatives of ω ≤ 5.5 rad/s over step², and float's 1e-8 m over the step.
    EXPECT_NEAR(now.verticalVelocity, (after.height - before.height) / (2 * step), 1e-3);
  }
}

TEST(Composition, AVesselLeavesOutItsOwnWakeAlone) {
  Wake wake;
  WaterSurface water(sea());
  std::vector<SurfaceSample> waves(points.size()), own(points.size()), other(points.size());
  water.sample(points, 10.0, waves);
  water.setDisturbances(wake.system.feed());
  water.sample(points, 10.0, own, {.excludeVessel = wake.vessel});
  water.sample(points, 10.0, other, {.excludeVessel = wake.vessel + 1});
  EXPECT_EQ(own[0].height, waves[0].height);
  EXPECT_NE(other[0].height, waves[0].height);
}

TEST(Composition, SamplingAWakeAllocatesNothing) {
  Wake wake;
  WaterSurface water(sea());
  water.setDisturbances(wake.system.feed());
  std::vector<SurfaceSample> samples(points.size());
  const auto before = test_support::allocationCount();
  water.sample(points, 10.0, samples, {.orbitalVelocity = true});
  EXPECT_EQ(test_support::allocationCount(), before);
}

TEST(Composition, MotionBelowIsThatOfTheSurfaceAtTheSurfaceAndDiesDown) {
  Wake wake;
  WaterSurface water{WaveField({})};
  water.setDisturbances(wake.system.feed());
  const SurfaceAtTime now = water.at(10.0);
  const SurfaceSample top = now.sample(points[0], {.orbitalVelocity = true});
  const std::vector<glm::dvec3> column{
      {points[0], top.height}, {points[0], top.height - 2.0}, {points[0], top.height - 40.0}};
  std::vector<WaterKinematics> motion(column.size());
  sampleKinematics(now, column, motion);
  // The wake's ∂η/∂t is w; places pass through float.
  EXPECT_NEAR(glm::length(motion[0].velocity - top.orbitalVelocity), 0.0, 1e-5);
  EXPECT_NEAR(motion[0].pressure, 0.0, 1e-3 * seaWaterDensity * standardGravity);
  EXPECT_LT(glm::length(motion[1].velocity), 0.9 * glm::length(motion[0].velocity));
  EXPECT_LT(glm::length(motion[2].velocity), 1e-3 * glm::length(motion[0].velocity));
  EXPECT_EQ(motion[0].surfaceHeight, top.height);
  sampleKinematics(now, column, motion, {.excludeVessel = wake.vessel});
  EXPECT_EQ(motion[2].velocity, glm::dvec3(0.0));
}

TEST(Composition, SplashesAndSmoothedWaterAreInSamplesAndInMotionBelow) {
  WaterSurface water(sea());
  const glm::dvec2 place(3.0, 4.0);
  water.setEvents(std::make_shared<const SurfaceEvents>(
      std::vector<Splash>{{.place = place, .time = 9.0}}, Rain{}, SurfaceEvents::Water{}));
  const SurfaceAtTime now = water.at(10.0);
  SurfaceSample waves;
  water.waves().sample(std::span(&place, 1), 10.0, std::span(&waves, 1));
  const SurfaceSample both = now.sample(place, {.orbitalVelocity = true});
  EXPECT_NE(both.height, waves.height);
  EXPECT_EQ(water.sample(place, 10.0).height, both.height);
  const std::vector<glm::dvec3> column{{place, both.height}, {place, both.height - 30.0}};
  std::vector<WaterKinematics> motion(2);
  sampleKinematics(now, column, motion);
  EXPECT_EQ(motion[0].surfaceHeight, both.height);
  EXPECT_NEAR(motion[0].pressure, 0.0, 1e-3 * seaWaterDensity * standardGravity);
  EXPECT_NEAR(glm::length(motion[0].velocity - both.orbitalVelocity), 0.0, 1e-5);
  std::vector<WaterKinematics> without(2);
  sampleKinematics(now.waves(), column, without);
  // The surface above is some centimetres higher, and the waves' motion with it: k Δη e⁻⁶ of 0.3
  // m/s.
  EXPECT_NEAR(glm::length(motion[1].velocity - without[1].velocity), 0.0, 1e-5);
}

TEST(Composition, AFieldWithoutLayersOrEventsIsSampledAsBefore) {
  WaterSurface water(sea());
  std::vector<SurfaceSample> before(points.size()), after(points.size());
  water.sample(points, 10.0, before);
  water.setDetail(std::make_shared<const SurfaceDetail>());
  water.sample(points, 10.0, after);
  for (std::size_t i = 0; i < points.size(); ++i) EXPECT_EQ(before[i].height, after[i].height);
}

}  // namespace
}  // namespace seaway
