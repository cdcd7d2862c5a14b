#include "sim_bridge/dynamics/hull_vessel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "surface/hull/analytic_hulls.h"
#include "tests/support/allocation_counter.h"

namespace seaway::bridge {
namespace {

const WaterSurface& stillWater() {
  static const WaterSurface water{WaveField({})};
  return water;
}

HullCoefficients undamped() {
  HullCoefficients none;
  none.formDrag = none.heaveDamping = none.rollDamping = none.pitchDamping = 0.0;
  none.skinFriction = 0.0;
  return none;
}

/// A box 1 × 0.6 × 0.3 m, 0.1 m deep in the water unless scaled.
std::shared_ptr<HullModel> box(const HullCoefficients& coefficients, double scale = 1.0,
                               double part = 1.0 / 3.0, LoadLevel level = LoadLevel::mesh) {
  HullSettings settings;
  settings.level = level;
  settings.mass = part * seaWaterDensity * 0.18 * scale * scale * scale;
  settings.centreOfGravity = {0.0, 0.0, -0.02 * scale};
  settings.gyradii = {0.3 * scale, 0.4 * scale, 0.4 * scale};
  settings.coefficients = coefficients;
  settings.columns = {5, 3};
  return std::make_shared<HullModel>(boxMesh(scale, 0.6 * scale, 0.3 * scale, 0.1 * scale, 120),
                                     settings);
}

/// Angular frequency by upward crossings of zero.
template <class Signal>
double frequencyOf(HullVessel& vessel, double seconds, double step, Signal signal) {
  double before = signal(), first = 0.0, last = 0.0;
  int crossings = 0;
  for (int i = 1; i * step < seconds; ++i) {
    vessel.advance(i * step, stillWater());
    const double now = signal();
    if (before < 0.0 && now >= 0.0) {
      last = (i - now / (now - before)) * step;
      if (crossings++ == 0) first = last;
    }
    before = now;
  }
  return 2.0 * pi * (crossings - 1) / (last - first);
}

// Semi-implicit Euler at ω dt ≤ 0.1: (ω dt)²/24.
TEST(HullVessel, HeavesAndRollsAtTheirNaturalFrequencies) {
  HullVessel vessel(box(undamped()));
  RigidMotion start = vessel.motion();
  start.position.z += 0.01;
  vessel.setMotion(start);
  const double heave = std::sqrt(standardGravity / 0.1);
  EXPECT_NEAR(frequencyOf(vessel, 10.0, 0.01, [&] { return vessel.pose().position.z; }), heave,
              1e-3 * heave);
  HullVessel roller(box(undamped()));
  start = roller.motion();
  start.worldFromBody = glm::angleAxis(0.01, glm::dvec3(1.0, 0.0, 0.0));
  roller.setMotion(start);
  const double gm = -0.05 + 0.36 / 1.2 + 0.02;
  const double roll = std::sqrt(standardGravity * gm) / 0.3;
  EXPECT_NEAR(frequencyOf(roller, 10.0, 0.01, [&] { return roller.motion().worldFromBody.x; }),
              roll, 2e-3 * roll);
}

TEST(HullVessel, AddedMassSlowsHeaveByItsShare) {
  HullCoefficients heavy = undamped();
  heavy.addedMass = {0.0, 0.0, 1.0, 0.0, 0.0, 0.0};
  HullVessel vessel(box(heavy));
  RigidMotion start = vessel.motion();
  start.position.z += 0.002;
  vessel.setMotion(start);
  // The wet part of the hull, hence its added mass, changes by 2 % on the way.
  const double heave = std::sqrt(standardGravity / 0.1 / 2.0);
  EXPECT_NEAR(frequencyOf(vessel, 10.0, 0.01, [&] { return vessel.pose().position.z; }), heave,
              0.01 * heave);
}

TEST(HullVessel, FreeSpinsKeepAngularMomentumAndEnergy) {
  HullVessel vessel(box(undamped()));
  RigidMotion start = vessel.motion();
  start.position.z = 1e4;  // in the air
  start.turning = {0.3, 1.5, 0.4};
  vessel.setMotion(start);
  const glm::dvec3 inertia = vessel.hull().settings().mass * glm::dvec3(0.09, 0.16, 0.16);
  const auto momentum = [&] {
    return vessel.motion().worldFromBody * (inertia * vessel.motion().turning);
  };
  const auto spin = [&] {
    return glm::dot(inertia * vessel.motion().turning, vessel.motion().turning);
  };
  const glm::dvec3 before = momentum();
  const double energy = spin();
  vessel.advance(20.0, stillWater());
  EXPECT_LT(glm::length(momentum() - before), 1e-9 * glm::length(before));
  EXPECT_NEAR(spin(), energy, 0.01 * energy);
}

TEST(HullVessel, AllocatesNothingOnceWarm) {
  HullVessel vessel(box(HullCoefficients{}));
  const WaterSurface water(WaveField({makeRegularWave(0.05, 0.4, 0.0)}));
  vessel.advance(0.1, water);
  const std::size_t before = test_support::allocationCount();
  vessel.advance(1.0, water);
  EXPECT_EQ(test_support::allocationCount(), before);
}

/// A launch of 12 m with one screw.
HullVesselSettings driven() {
  HullVesselSettings settings;
  settings.propeller.diameter = 0.6;
  settings.propeller.position = {-5.0, 0.0, -0.45};
  settings.propeller.mostRevolutions = 25.0;
  settings.rudder.area = 0.35;
  settings.rudder.position = {-5.6, 0.0, -0.4};
  settings.rudder.mostRate_deg = 15.0;
  return settings;
}

std::shared_ptr<HullModel> launch() {
  HullSettings settings;
  settings.level = LoadLevel::mesh;
  const TriangleMesh mesh = wigleyMesh(12.0, 3.0, 0.8, 1.0, 300);
  settings.mass = seaWaterDensity * submergedPart(mesh, WaterPlane::at(0.0)).volume;
  settings.centreOfGravity = {0.0, 0.0, 0.1};
  settings.coefficients.formDrag = 0.2;
  settings.coefficients.addedMass = {0.05, 0.8, 1.0, 0.2, 0.8, 0.5};
  return std::make_shared<HullModel>(mesh, settings);
}

TEST(HullVessel, PropellersBringTheAskedSpeedAndAutopilotsHoldTheirTrack) {
  HullVessel vessel(launch(), driven());
  vessel.place({0.0, 0.0}, 0.3, 0.0);
  vessel.setAutopilot({.waypoints = {{150.0, 0.0}, {150.0, 200.0}, {150.0, 900.0}},
                       .speed = 5.0,
                       .shipLength = 12.0});
  for (int i = 1; i <= 1000; ++i) vessel.advance(0.1 * i, stillWater());
  EXPECT_EQ(vessel.autopilot()->nextWaypoint(), 2u);
  EXPECT_NEAR(glm::length(vessel.motion().velocity), 5.0, 0.25);
  EXPECT_LT(std::abs(vessel.autopilot()->crossTrack(glm::dvec2(vessel.pose().position))), 2.0);
}

TEST(HullVessel, RuddersToStarboardTurnTheBowThere) {
  HullVessel vessel(launch(), driven());
  vessel.place({0.0, 0.0}, 0.0, 5.0);
  vessel.setHelm({.revolutions = 12.0, .rudder = 0.3});
  for (int i = 1; i <= 50; ++i) vessel.advance(0.1 * i, stillWater());
  EXPECT_LT(vessel.motion().turning.z, -0.02);
  EXPECT_LT(vessel.motion().position.y, 0.0);
}

TEST(HullVessel, BodiesAdriftTakeUpTheCurrent) {
  HullVessel vessel(box(HullCoefficients{}));
  const WaterSurface stream(WaveField({}, {.current = {0.7, -0.2}}));
  for (int i = 1; i <= 600; ++i) vessel.advance(0.1 * i, stream);
  EXPECT_NEAR(vessel.motion().velocity.x, 0.7, 0.05);
  EXPECT_NEAR(vessel.motion().velocity.y, -0.2, 0.05);
}

TEST(HullVesselHard, CapsizedHullsRightThemselvesOrFloatUpsideDown) {
  for (const double heel : {2.0, 3.1, -2.5}) {
    HullVessel vessel(box(HullCoefficients{}));
    RigidMotion start = vessel.motion();
    start.worldFromBody = glm::angleAxis(heel, glm::dvec3(1.0, 0.0, 0.0));
    vessel.setMotion(start);
    for (int i = 1; i <= 600; ++i) vessel.advance(0.1 * i, stillWater());
    EXPECT_NEAR(vessel.lastLoads().submergedVolume, 0.06, 1e-4) << heel;
    EXPECT_LT(glm::length(vessel.motion().turning), 1e-2);
  }
}

// A keel weight: stable only upright, it comes back from beyond 90 degrees.
TEST(HullVesselHard, BallastedHullsComeBackUpright) {
  HullSettings settings;
  settings.level = LoadLevel::mesh;
  const TriangleMesh mesh = sphereMesh(0.5, 200);
  settings.mass = 0.5 * seaWaterDensity * massProperties(mesh).volume;
  settings.centreOfGravity = {0.0, 0.0, -0.2};
  settings.gyradii = glm::dvec3(0.3);
  HullVessel vessel(std::make_shared<HullModel>(mesh, settings));
  RigidMotion start = vessel.motion();
  start.worldFromBody = glm::angleAxis(3.0, glm::dvec3(1.0, 0.0, 0.0));
  vessel.setMotion(start);
  for (int i = 1; i <= 600; ++i) vessel.advance(0.1 * i, stillWater());
  const glm::dvec3 up = vessel.motion().worldFromBody * glm::dvec3(0.0, 0.0, 1.0);
  EXPECT_GT(up.z, 0.9999);
}

TEST(HullVesselHard, HullsThrownInAndHeldUnderComeBack) {
  for (const double z : {-20.0, 10.0}) {
    HullVessel vessel(box(HullCoefficients{}));
    RigidMotion start = vessel.motion();
    start.position.z = z;
    vessel.setMotion(start);
    for (int i = 1; i <= 900; ++i) {
      vessel.advance(0.05 * i, stillWater());
      ASSERT_LT(std::abs(vessel.motion().position.z), 25.0);
    }
    EXPECT_NEAR(vessel.lastLoads().submergedVolume, 0.06, 1e-4) << z;
  }
}

// The bow goes in, the deck goes under, and the hull comes up behind the crest.
TEST(HullVesselHard, BowsDiveThroughASteepCrestAndComeUp) {
  const WaterSurface crest(WaveField({makeRegularWave(1.2, 0.25, pi)}));
  HullVessel vessel(launch(), driven());
  vessel.place({0.0, 0.0}, 0.0, 7.0);
  vessel.setHelm({.revolutions = 20.0});
  double mostWet = 0.0;
  const double own = massProperties(vessel.hull().mesh()).volume;
  for (int i = 1; i <= 600; ++i) {
    vessel.advance(0.05 * i, crest);
    mostWet = std::max(mostWet, vessel.lastLoads().submergedVolume);
    ASSERT_TRUE(std::isfinite(vessel.motion().position.z));
    ASSERT_LT(std::abs(vessel.motion().position.z), 5.0);
    ASSERT_LT(glm::length(vessel.motion().velocity), 20.0);
  }
  EXPECT_GT(mostWet, 1.2 * vessel.hull().atRest().volume);
  EXPECT_LE(mostWet, 1.0000001 * own);
}

TEST(HullVesselHard, CubesOfAMillimetreTankersAndExtremeDensitiesStayAfloat) {
  HullCoefficients damped;
  for (const double scale : {1e-3, 400.0}) {
    for (const double part : {0.01, 0.99}) {
      HullVessel vessel(box(damped, scale, part));
      const double step = 0.02 / vessel.hull().heaveFrequency();
      for (int i = 1; i <= 2000; ++i) vessel.advance(i * step, stillWater());
      EXPECT_NEAR(vessel.lastLoads().submergedVolume, part * 0.18 * std::pow(scale, 3),
                  1e-6 * std::pow(scale, 3));
    }
  }
}

// Heave in 0.2 s: a draft of 1 cm. Undamped, with water drag off: nothing may feed energy in.
TEST(HullVesselHard, LongStepsOverAStiffHullAreStableAndGainNoEnergy) {
  HullSettings settings;
  settings.level = LoadLevel::mesh;
  settings.mass = seaWaterDensity * 0.6 * 0.0099;
  settings.centreOfGravity.z = -0.02;
  settings.coefficients = undamped();
  HullVessel vessel(std::make_shared<HullModel>(boxMesh(1.0, 0.6, 0.3, 0.1, 120), settings));
  ASSERT_NEAR(2.0 * pi / vessel.hull().heaveFrequency(), 0.2, 0.002);
  RigidMotion start = vessel.motion();
  const double rest = start.position.z;
  start.position.z += 0.005;
  vessel.setMotion(start);
  double early = 0.0, late = 0.0;
  for (int i = 1; i <= 2000; ++i) {
    vessel.advance(0.1 * i, stillWater());
    const double deflection = std::abs(vessel.motion().position.z - rest);
    (i <= 200 ? early : late) = std::max(i <= 200 ? early : late, deflection);
  }
  // Semi-implicit Euler's ripple of energy is ω dt/2 = 5 %.
  EXPECT_LT(late, 1.05 * 0.005);
  EXPECT_GT(late, 0.9 * early);
}

TEST(HullVesselHard, TwentyHullsWeatherAStormForAnHour) {
  std::vector<Octave> octaves;
  for (int i = 0; i < 8; ++i) {
    octaves.push_back(makeGroupOctave(1.0, 0.07 + 0.012 * i, 0.01, 0.2 * i, 0.6));
  }
  const WaterSurface storm(WaveField(octaves, {.seed = 3}));  // H_m0 11 m
  const auto hull = box(HullCoefficients{}, 100.0, 1.0 / 3.0, LoadLevel::columns);
  std::vector<HullVessel> fleet(20, HullVessel(hull));
  for (std::size_t i = 0; i < fleet.size(); ++i) {
    fleet[i].place({100.0 * static_cast<double>(i), 0.0}, 0.3 * static_cast<double>(i), 0.0);
  }
  const double weight = hull->settings().mass * standardGravity;
  for (int i = 1; i <= 14400; ++i) {
    for (HullVessel& vessel : fleet) vessel.advance(0.25 * i, storm);
    if (i % 40 != 0) continue;
    for (const HullVessel& vessel : fleet) {
      ASSERT_TRUE(std::isfinite(vessel.energy())) << i;
      // No more than a crest of 15 m lifts it and a crest's water moves it.
      ASSERT_LT(std::abs(vessel.energy()), 40.0 * weight) << i;
    }
  }
}

}  // namespace
}  // namespace seaway::bridge
