#include "sim_bridge/vessel/prescribed_vessel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "surface/constants.h"

namespace seaway::bridge {
namespace {

using Water = std::function<SurfaceSample(glm::dvec2, double)>;

SurfaceSample flat(glm::dvec2, double) { return {}; }

BoxHull launch() {
  BoxHull hull;
  hull.length = 12.0;
  hull.beam = 3.6;
  hull.depth = 2.0;
  hull.givenDraft = 0.55;
  hull.centreOfGravityAboveKeel = 1.25;
  return hull;
}

BoxHull undamped(BoxHull hull) {
  hull.heaveDamping = hull.rollDamping = hull.pitchDamping = 0.0;
  return hull;
}

const Course atRest({0.0, 0.0}, 0.4, 0.0, 0.0);

// A vessel on water given by a function.
struct Sailing {
  Sailing(const BoxHull& hull, const Course& course, Water itsWater)
      : vessel(hull, course),
        water(std::move(itsWater)),
        points(vessel.sampleCount()),
        samples(vessel.sampleCount()) {
    sample(0.0);
    vessel.settle(0.0, samples);
  }
  void sample(double t) {
    vessel.samplePoints(t, points);
    for (std::size_t i = 0; i < points.size(); ++i) samples[i] = water(points[i], t);
  }
  void advance(double t) {
    sample(t);
    vessel.advance(t, samples);
  }

  PrescribedVessel vessel;
  Water water;
  std::vector<glm::dvec2> points;
  std::vector<SurfaceSample> samples;
};

// Angular frequency from the first and last upward zero crossings of `signal` over 60 s.
double measuredFrequency(Sailing& sailing, double (*signal)(const VesselPose&)) {
  const double step = 0.01;
  double before = signal(sailing.vessel.pose());
  double first = 0.0;
  double last = 0.0;
  int crossings = 0;
  for (int i = 1; i <= 6000; ++i) {
    sailing.advance(i * step);
    const double now = signal(sailing.vessel.pose());
    if (before < 0.0 && now >= 0.0) {
      last = (i - now / (now - before)) * step;
      if (crossings++ == 0) first = last;
    }
    before = now;
  }
  return 2.0 * pi * (crossings - 1) / (last - first);
}

TEST(BoxHull, MassAndDraftAgreeWithArchimedes) {
  BoxHull hull = launch();
  EXPECT_NEAR(hull.mass(), seaWaterDensity * 12.0 * 3.6 * 0.55, 1e-9);
  hull.givenDraft.reset();
  hull.givenMass = 20000.0;
  EXPECT_NEAR(hull.draft(), 20000.0 / (seaWaterDensity * 12.0 * 3.6), 1e-12);
}

TEST(BoxHull, ColumnsHaveTheBoxesAreaAndSecondMomentsForAnyNumber) {
  for (const glm::ivec2 columns : {glm::ivec2(2, 2), glm::ivec2(9, 3), glm::ivec2(40, 17)}) {
    BoxHull hull = launch();
    hull.columns = columns;
    double area = 0.0;
    double across = 0.0;
    double along = 0.0;
    for (const HullColumn& column : hullColumns(hull)) {
      area += column.area;
      along += column.area * column.place.x * column.place.x;
      across += column.area * column.place.y * column.place.y;
      EXPECT_LT(std::abs(column.place.x), 6.0);
      EXPECT_LT(std::abs(column.place.y), 1.8);
    }
    EXPECT_NEAR(area, 12.0 * 3.6, 1e-9);
    EXPECT_NEAR(along, 3.6 * std::pow(12.0, 3) / 12.0, 1e-9);
    EXPECT_NEAR(across, 12.0 * std::pow(3.6, 3) / 12.0, 1e-9);
  }
}

TEST(PrescribedVessel, StaysAtItsDraftInStillWater) {
  Sailing sailing(launch(), atRest, flat);
  for (int i = 1; i <= 500; ++i) sailing.advance(0.02 * i);
  // Rounding alone moves it.
  EXPECT_NEAR(sailing.vessel.pose().height, 0.0, 1e-9);
  EXPECT_NEAR(sailing.vessel.submergedVolume(), 12.0 * 3.6 * 0.55, 1e-8);
}

TEST(PrescribedVessel, ReturnsToItsDraftWithinAThousandthWhenPushed) {
  Sailing sailing(launch(), atRest, flat);
  sailing.vessel.displace(-0.3, 0.1, 0.05);
  for (int i = 1; i <= 3000; ++i) sailing.advance(0.02 * i);
  EXPECT_NEAR(sailing.vessel.pose().height, 0.0, 1e-3 * 0.55);
  EXPECT_NEAR(sailing.vessel.pose().roll, 0.0, 1e-4);
  EXPECT_NEAR(sailing.vessel.pose().pitch, 0.0, 1e-4);
}

// Linear theory without added mass; 0.2 %: semi-implicit Euler at
// ω dt ≤ 0.1 errs by (ω dt)²/24 = 0.04 %, crossings by interpolation over 60 s; angles are small.
TEST(PrescribedVessel, HeavesAtTheFrequencyOfItsWaterplane) {
  const BoxHull hull = undamped(launch());
  Sailing sailing(hull, atRest, flat);
  sailing.vessel.displace(0.02, 0.0, 0.0);
  const double theory = std::sqrt(seaWaterDensity * standardGravity * 12.0 * 3.6 / hull.mass());
  const double measured =
      measuredFrequency(sailing, [](const VesselPose& pose) { return pose.height; });
  EXPECT_NEAR(measured, theory, 2e-3 * theory);
}

TEST(PrescribedVessel, RollsAtTheFrequencyOfItsMetacentricHeight) {
  const BoxHull hull = undamped(launch());
  Sailing sailing(hull, atRest, flat);
  sailing.vessel.displace(0.0, 0.01, 0.0);
  const double gm = 0.55 / 2.0 + 3.6 * 3.6 / (12.0 * 0.55) - 1.25;
  const double theory = std::sqrt(standardGravity * gm) / (0.35 * 3.6);
  const double measured =
      measuredFrequency(sailing, [](const VesselPose& pose) { return pose.roll; });
  EXPECT_NEAR(measured, theory, 2e-3 * theory);
}

TEST(PrescribedVessel, PitchesAtTheFrequencyOfItsLongitudinalMetacentricHeight) {
  const BoxHull hull = undamped(launch());
  Sailing sailing(hull, atRest, flat);
  sailing.vessel.displace(0.0, 0.0, 0.005);
  const double gm = 0.55 / 2.0 + 12.0 * 12.0 / (12.0 * 0.55) - 1.25;
  const double theory = std::sqrt(standardGravity * gm) / (0.25 * 12.0);
  const double measured =
      measuredFrequency(sailing, [](const VesselPose& pose) { return pose.pitch; });
  EXPECT_NEAR(measured, theory, 2e-3 * theory);
}

// λ = 40 L: the hull lies along the water. What is left of its inertia is of the order of (ω/ω₀)²,
// 2 % at the slowest natural frequency (roll's 2.5 rad/s against 0.36), and about as much again
// while the start dies down.
TEST(PrescribedVessel, FollowsLongWavesAtAnySpeedAndHeading) {
  const double amplitude = 1.0;
  const double k = 2.0 * pi / 480.0;
  const double omega = std::sqrt(standardGravity * k);
  const Water wave = [=](glm::dvec2 p, double t) {
    SurfaceSample sample;
    sample.height = amplitude * std::sin(k * p.x - omega * t);
    sample.slope = {amplitude * k * std::cos(k * p.x - omega * t), 0.0};
    sample.verticalVelocity = -omega * amplitude * std::cos(k * p.x - omega * t);
    return sample;
  };
  for (const double speed : {0.0, 6.0}) {
    for (const double direction : {0.0, pi, pi / 2.0}) {
      Sailing sailing(launch(), Course({0.0, 0.0}, direction, speed, 0.0), wave);
      for (int i = 1; i <= 2000; ++i) {
        const double t = 0.02 * i;
        sailing.advance(t);
        const VesselPose pose = sailing.vessel.pose();
        const SurfaceSample water = wave(pose.position, t);
        ASSERT_NEAR(pose.height, water.height, 0.02 * amplitude) << t << " " << direction;
        const double forward = water.slope.x * std::cos(direction);
        const double toPort = -water.slope.x * std::sin(direction);
        ASSERT_NEAR(pose.pitch, forward, 0.05 * amplitude * k) << t << " " << direction;
        ASSERT_NEAR(pose.roll, toPort, 0.05 * amplitude * k) << t << " " << direction;
      }
    }
  }
}

TEST(PrescribedVessel, BowRisesOnAWaveAheadAndStarboardSinksOnAWaveToPort) {
  const Water risingAhead = [](glm::dvec2 p, double) {
    SurfaceSample sample;
    sample.height = 0.05 * p.x;
    return sample;
  };
  const Sailing east(launch(), Course({0.0, 0.0}, 0.0, 0.0, 0.0), risingAhead);
  EXPECT_NEAR(east.vessel.pose().pitch, std::atan(0.05), 1e-9);
  // Heading south, east is to port: water is higher there, starboard lies deeper.
  const Sailing south(launch(), Course({0.0, 0.0}, -pi / 2.0, 0.0, 0.0), risingAhead);
  EXPECT_NEAR(south.vessel.pose().roll, std::atan(0.05), 1e-9);
}

TEST(PrescribedVessel, DampedMotionLosesEnergyAndUndampedKeepsIt) {
  Sailing free(undamped(launch()), atRest, flat);
  free.vessel.displace(0.05, 0.0, 0.0);
  double largestLate = 0.0;
  for (int i = 1; i <= 30000; ++i) {
    free.advance(0.02 * i);
    if (i > 29000) largestLate = std::max(largestLate, std::abs(free.vessel.pose().height));
  }
  // Semi-implicit Euler keeps energy on average; its ripple is ω dt/2 = 5 %.
  EXPECT_NEAR(largestLate, 0.05, 0.05 * 0.05);
}

TEST(VesselHard, LongStepsAreStable) {
  Sailing sailing(undamped(launch()), atRest, flat);
  sailing.vessel.displace(0.3, 0.2, 0.1);
  for (int i = 1; i <= 5000; ++i) {
    sailing.advance(0.7 * i);
    ASSERT_LT(std::abs(sailing.vessel.pose().height), 0.6) << i;
  }
}

TEST(VesselHard, ComesBackFromCapsizedUnderAndOut) {
  struct Start {
    double heave, roll, pitch;
  };
  for (const Start start : {Start{0.0, 3.1, 0.0}, Start{-20.0, 0.0, 0.0}, Start{15.0, 0.3, -0.2},
                            Start{0.0, 1.5707963, 0.0}}) {
    Sailing sailing(launch(), atRest, flat);
    sailing.vessel.displace(start.heave, start.roll, start.pitch);
    for (int i = 1; i <= 6000; ++i) {
      sailing.advance(0.02 * i);
      ASSERT_TRUE(std::isfinite(sailing.vessel.pose().height));
    }
    // Upright or on its back, it floats with its own volume under water.
    EXPECT_NEAR(sailing.vessel.submergedVolume(), 12.0 * 3.6 * 0.55, 0.05);
  }
}

TEST(VesselHard, LightAndHeavyHullsFloat) {
  for (const double part : {0.01, 0.99}) {
    BoxHull hull = launch();
    hull.givenDraft = part * hull.depth;
    hull.centreOfGravityAboveKeel = 0.5;
    ASSERT_FALSE(hull.fault());
    Sailing sailing(hull, atRest, flat);
    for (int i = 1; i <= 1000; ++i) sailing.advance(0.02 * i);
    EXPECT_NEAR(sailing.vessel.pose().height, 0.0, 1e-3 * hull.draft());
  }
}

}  // namespace
}  // namespace seaway::bridge
