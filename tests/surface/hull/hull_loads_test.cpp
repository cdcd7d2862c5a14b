#include "surface/hull/hull_loads.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <random>

#include "surface/angles.h"
#include "surface/dispersion.h"
#include "surface/disturbance/wake_system.h"
#include "surface/hull/analytic_hulls.h"
#include "surface/input_error.h"
#include "tests/support/allocation_counter.h"

namespace seaway {
namespace {

constexpr double weightDensity = seaWaterDensity * standardGravity;
const WaterSurface& stillWater() {
  static const WaterSurface water{WaveField({})};
  return water;
}

HullModel model(const TriangleMesh& mesh, double mass, LoadLevel level = LoadLevel::meshDynamic) {
  HullSettings settings;
  settings.level = level;
  settings.mass = mass;
  settings.centreOfGravity = massProperties(mesh).centroid;
  return {mesh, settings};
}

HullModel halfFloating(const TriangleMesh& mesh, LoadLevel level = LoadLevel::meshDynamic) {
  return model(mesh, 0.5 * seaWaterDensity * massProperties(mesh).volume, level);
}

glm::dquat randomAttitude(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  return glm::normalize(glm::dquat(normal(random), normal(random), normal(random), normal(random)));
}

// Sums of 800 rounded terms of some 30 times the result: 1e-13. The mesh's own volume is exact.
TEST(HullLoads, SubmergedHullsFeelTheirDisplacementUpwardsAndNoTorqueAtAnyAttitude) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> depth(2.0, 30.0);
  LoadScratch scratch;
  for (const TriangleMesh& mesh : {wigleyMesh(2.0, 0.4, 0.2, 0.1), boxMesh(1.0, 0.5, 0.4, 0.2)}) {
    const HullModel hull = halfFloating(mesh);
    const MassProperties whole = massProperties(mesh);
    const double weight = weightDensity * whole.volume;
    for (int i = 0; i < 500; ++i) {
      HullPose pose;
      pose.worldFromBody = randomAttitude(random);
      pose.position = {100.0, -50.0, -depth(random)};
      const HullLoads load = loads(hull, pose, stillWater(), 0.0, scratch);
      const glm::dvec3 error = load.total().force - glm::dvec3(0.0, 0.0, weight);
      ASSERT_LT(glm::length(error), 1e-9 * weight);
      const glm::dvec3 arm = pose.worldFromBody * whole.centroid;
      const glm::dvec3 torque = load.total().moment - glm::cross(arm, load.total().force);
      ASSERT_LT(glm::length(torque), 1e-9 * weight * hull.length());
      ASSERT_NEAR(load.submergedVolume, whole.volume, 1e-9 * whole.volume);
      ASSERT_NEAR(load.wettedArea, whole.area, 1e-9 * whole.area);
    }
  }
}

TEST(HullLoads, AgreeWithHydrostaticsAtAnyDraftAndAttitude) {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> height(-0.3, 0.3);
  const TriangleMesh mesh = wigleyMesh(2.0, 0.4, 0.2, 0.1);
  const HullModel hull = halfFloating(mesh);
  const double weight = weightDensity * massProperties(mesh).volume;
  LoadScratch scratch;
  for (int i = 0; i < 300; ++i) {
    HullPose pose;
    pose.worldFromBody = randomAttitude(random);
    pose.position.z = height(random);
    const HullLoads load = loads(hull, pose, stillWater(), 0.0, scratch);
    const glm::dvec3 up = glm::inverse(pose.worldFromBody) * glm::dvec3(0.0, 0.0, 1.0);
    const SubmergedPart part = submergedPart(mesh, {up, -pose.position.z});
    const glm::dvec3 force(0.0, 0.0, weightDensity * part.volume);
    ASSERT_LT(glm::length(load.total().force - force), 1e-9 * weight);
    const glm::dvec3 moment = glm::cross(pose.worldFromBody * part.centre, force);
    ASSERT_LT(glm::length(load.total().moment - moment), 1e-9 * weight * hull.length());
    ASSERT_NEAR(load.submergedVolume, part.volume, 1e-9 * part.volume + 1e-15);
    ASSERT_NEAR(load.wettedArea, part.wettedArea, 1e-9 * hull.length());
  }
}

// A closed path through every kind of wetness. The trapezium rule on a smooth periodic integrand
// converges at once; kinks where vertices pass the surface leave O(h³): 1e-7 at 20 000 steps.
TEST(HullLoads, StillWaterDoesNoWorkAroundAClosedPath) {
  const HullModel hull = halfFloating(wigleyMesh(2.0, 0.4, 0.2, 0.1, 400));
  LoadScratch scratch;
  const int steps = 20000;
  const auto poseAt = [](double s) {
    const double a = 2.0 * pi * s;
    HullPose pose;
    pose.position = {std::cos(a), std::sin(2.0 * a), 0.25 * std::sin(a) + 0.05};
    pose.worldFromBody = glm::angleAxis(0.8 * std::sin(a), glm::dvec3(1.0, 0.0, 0.0)) *
                         glm::angleAxis(0.5 * std::cos(2.0 * a), glm::dvec3(0.0, 1.0, 0.0)) *
                         glm::angleAxis(a, glm::dvec3(0.0, 0.0, 1.0));
    return pose;
  };
  double work = 0.0, passed = 0.0;
  const double h = 1.0 / steps;
  for (int i = 0; i < steps; ++i) {
    const double s = (i + 0.5) * h;
    const HullPose before = poseAt(s - 0.01 * h), after = poseAt(s + 0.01 * h);
    // Velocities by a narrow central difference: relative 1e-9.
    const glm::dvec3 velocity = (after.position - before.position) / (0.02 * h);
    const glm::dquat turn = after.worldFromBody * glm::inverse(before.worldFromBody);
    const glm::dvec3 turning = 2.0 * glm::dvec3(turn.x, turn.y, turn.z) / (0.02 * h);
    const Load load = loads(hull, poseAt(s), stillWater(), 0.0, scratch).buoyancy;
    const double power = glm::dot(load.force, velocity) + glm::dot(load.moment, turning);
    work += power * h;
    passed += std::abs(power) * h;
  }
  EXPECT_LT(std::abs(work), 1e-6 * passed);
}

TEST(HullLoads, CalibratedHullsDisplaceWhatIsKnownAtDesignAndOtherDrafts) {
  const double l = 10.0, b = 1.0, t = 0.625, exact = 4.0 / 9.0 * l * b * t;
  const TriangleMesh mesh = wigleyMesh(l, b, t, 0.4, 800);
  HullSettings settings;
  settings.mass = seaWaterDensity * exact;
  settings.centreOfGravity.z = -0.3;
  settings.knownVolume = exact;
  const HullModel hull(mesh, settings);
  EXPECT_NEAR(hull.restHeight(), 0.0, 5e-4 * t);
  LoadScratch scratch;
  for (const double draft : {t, 0.9 * t, 0.8 * t}) {
    HullPose pose;
    pose.position.z = t - draft;
    const double s = 1.0 - draft / t;
    // ∫ from −1 to −s of (1 − z²) dz.
    const double volume = 2.0 / 3.0 * l * b * t * (2.0 / 3.0 - s + s * s * s / 3.0);
    const double found = loads(hull, pose, stillWater(), 0.0, scratch).submergedVolume;
    EXPECT_NEAR(found, volume, (s > 0.0 ? 2e-3 : 5e-4) * volume)
        << draft << ": off by " << 100.0 * (found / volume - 1.0) << " %";
  }
}

/// A box that rests half deep in a regular wave along x.
struct WaveCase {
  WaveCase(double itsLength, double wavelength, LoadLevel level)
      : length(itsLength), k(2.0 * pi / wavelength), waves(waveOf(k)) {
    HullSettings settings;
    settings.level = level;
    settings.mass = 0.5 * seaWaterDensity * length * beam * 2.0 * draft;
    settings.shortestWavelength = 0.0;
    settings.coefficients.formDrag = settings.coefficients.heaveDamping = 0.0;
    settings.coefficients.rollDamping = settings.coefficients.pitchDamping = 0.0;
    settings.coefficients.skinFriction = 0.0;
    settings.columns = {80, 4};
    hull.emplace(boxMesh(length, beam, 2.0 * draft, draft, 6000), settings);
  }
  WaveField waveOf(double number) const {
    const double frequency = std::sqrt(standardGravity * number) / (2.0 * pi);
    return WaveField({makeRegularWave(amplitude, frequency, 0.0)});
  }
  double amplitude = 1e-3, beam = 0.2, draft = 0.05, length, k;
  WaterSurface waves;
  std::optional<HullModel> hull;

  HullLoads at(double t) {
    LoadScratch scratch;
    return loads(*hull, {}, waves, t, scratch);
  }
};

// Froude–Krylov theory of a box: F = ρg a B e^(−kT) 2 sin(kL/2)/k. Pressure is linear over panels
// of L/60 at most and the wave 1 % of the draft: 0.5 %.
TEST(HullLoads, HeaveForceOfABoxInRegularWavesIsFroudeAndKrylovs) {
  for (const double ratio : {1.5, 2.0, 5.0, 20.0}) {
    WaveCase box(1.0, ratio, LoadLevel::meshDynamic);
    const double still = weightDensity * box.length * box.beam * box.draft;
    const double theory = weightDensity * box.amplitude * box.beam * std::exp(-box.k * box.draft) *
                          2.0 * std::sin(0.5 * box.k * box.length) / box.k;
    EXPECT_NEAR(box.at(0.0).buoyancy.force.z - still, theory, 5e-3 * theory) << ratio;
  }
}

TEST(HullLoads, HeaveForceVanishesWhereTheWaveIsAsLongAsTheBox) {
  WaveCase box(1.0, 1.0, LoadLevel::meshDynamic);
  WaveCase longWave(1.0, 20.0, LoadLevel::meshDynamic);
  const double still = weightDensity * box.length * box.beam * box.draft;
  const double full = longWave.at(0.0).buoyancy.force.z - still;
  const double period = 2.0 * pi / std::sqrt(standardGravity * box.k);
  for (int i = 0; i < 8; ++i) {
    EXPECT_LT(std::abs(box.at(i * period / 8.0).buoyancy.force.z - still), 0.01 * full);
  }
}

TEST(HullLoads, LevelsAgreeInLongWavesAndStillWater) {
  for (const LoadLevel level : {LoadLevel::columns, LoadLevel::mesh, LoadLevel::meshDynamic}) {
    WaveCase box(1.0, 60.0, level);
    const double still = weightDensity * box.length * box.beam * box.draft;
    // e^(−kT) is 0.995.
    EXPECT_NEAR(box.at(0.0).buoyancy.force.z - still,
                weightDensity * box.amplitude * box.length * box.beam,
                0.01 * weightDensity * box.amplitude * box.length * box.beam);
    // A quarter period later the box lies on the wave's slope and is pushed down it.
    const double period = 2.0 * pi / std::sqrt(standardGravity * box.k);
    EXPECT_NEAR(box.at(0.25 * period).buoyancy.force.x, -still * box.k * box.amplitude,
                0.05 * still * box.k * box.amplitude)
        << static_cast<int>(level);
  }
}

TEST(HullLoads, ColumnsRightAShipAsItsMeshDoes) {
  const TriangleMesh mesh = wigleyMesh(10.0, 1.5, 0.6, 0.5);
  const double mass = seaWaterDensity * 3.5;
  const HullModel exact = model(mesh, mass), columns = model(mesh, mass, LoadLevel::columns);
  LoadScratch scratch;
  for (const glm::dvec3 axis : {glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(0.0, 1.0, 0.0)}) {
    HullPose pose;
    pose.position.z = exact.restHeight();
    pose.worldFromBody = glm::angleAxis(0.03, axis);
    const auto rightingMoment = [&](const HullModel& hull) {
      const HullLoads load = loads(hull, pose, stillWater(), 0.0, scratch);
      const glm::dvec3 arm = pose.worldFromBody * hull.settings().centreOfGravity;
      return glm::dot(load.buoyancy.moment - glm::cross(arm, load.buoyancy.force), axis);
    };
    // The waterplane's moments are the mesh's; its flare and the height of B are not.
    EXPECT_NEAR(rightingMoment(columns), rightingMoment(exact),
                0.05 * std::abs(rightingMoment(exact)));
  }
}

TEST(HullLoads, DragOpposesMotionThroughTheWaterAndCarriesWithTheCurrent) {
  const TriangleMesh mesh = wigleyMesh(10.0, 1.5, 0.6, 0.5);
  const HullModel hull = halfFloating(mesh);
  LoadScratch scratch;
  std::mt19937_64 random(6);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 100; ++i) {
    HullPose pose;
    pose.position.z = hull.restHeight();
    pose.velocity = {normal(random), normal(random), normal(random)};
    pose.angularVelocity = {normal(random), normal(random), normal(random)};
    const HullLoads load = loads(hull, pose, stillWater(), 0.0, scratch);
    const Load lost{load.drag.force + load.radiation.force,
                    load.drag.moment + load.radiation.moment};
    EXPECT_LT(glm::dot(lost.force, pose.velocity) + glm::dot(lost.moment, pose.angularVelocity),
              0.0);
  }
  const WaterSurface stream{WaveField({}, {.current = {1.5, -0.5}})};
  HullPose drifting;
  drifting.position.z = hull.restHeight();
  drifting.velocity = {1.5, -0.5, 0.0};
  EXPECT_NEAR(glm::length(loads(hull, drifting, stream, 0.0, scratch).drag.force), 0.0, 1e-9);
  drifting.velocity = {};
  EXPECT_GT(loads(hull, drifting, stream, 0.0, scratch).drag.force.x, 0.0);
}

// A plate of area A across the flow has C_D = 2C; the ITTC line at Re = 1e7 is 0.003.
TEST(HullLoads, PlatesHaveTheDragTheirCoefficientsState) {
  const TriangleMesh plate = moved(boxMesh(0.002, 1.0, 1.0, 0.5), {0.0, 0.0, 0.0});
  HullSettings settings;
  settings.mass = 0.5 * seaWaterDensity * 0.002;
  settings.coefficients.formDrag = 0.6;
  settings.coefficients.skinFriction = 0.0;
  settings.coefficients.heaveDamping = 0.0;
  LoadScratch scratch;
  HullPose pose;
  pose.position.z = -3.0;
  pose.velocity = {2.0, 0.0, 0.0};
  const HullModel across(plate, settings);
  EXPECT_NEAR(loads(across, pose, stillWater(), 0.0, scratch).drag.force.x,
              -0.5 * seaWaterDensity * 1.2 * 4.0, 1e-6);
  settings.coefficients.skinFriction.reset();
  const HullModel skin(plate, settings);
  pose.velocity = {0.0, 0.0, 2.0};
  const double reynolds = 2.0 * 0.002 / 1.19e-6;
  const double friction = 0.075 / std::pow(std::log10(reynolds) - 2.0, 2);
  EXPECT_NEAR(loads(skin, pose, stillWater(), 0.0, scratch).drag.force.z,
              -0.5 * seaWaterDensity * 4.0 * (friction * 2.004 + 1.2 * 0.002), 0.01);
}

TEST(HullLoads, WindPushesWhatIsOutOfTheWater) {
  const TriangleMesh mesh = boxMesh(2.0, 1.0, 1.0, 0.5);
  const HullModel hull = halfFloating(mesh);
  LoadScratch scratch;
  const HullLoads load =
      loads(hull, {}, stillWater(), 0.0, scratch, {.wind = glm::dvec2(0.0, 10.0)});
  EXPECT_NEAR(load.wind.force.y, 0.5 * airDensity * 1.0 * 100.0 * 2.0 * 0.5, 1e-6);
  EXPECT_NEAR(load.wind.moment.x, -0.25 * load.wind.force.y, 1e-6);
  EXPECT_EQ(loads(hull, {}, stillWater(), 0.0, scratch).wind.force.y, 0.0);
}

TEST(HullLoads, SlammingIsOffUnlessAskedForAndResistsEntry) {
  HullSettings settings;
  settings.mass = 100.0;
  HullPose pose;
  pose.position.z = 0.45;
  pose.velocity.z = -3.0;
  LoadScratch scratch;
  const TriangleMesh mesh = sphereMesh(0.5);
  const double without =
      loads(HullModel(mesh, settings), pose, stillWater(), 0.0, scratch).drag.force.z;
  settings.coefficients.slamming = 5.0;
  const HullModel slams(mesh, settings);
  EXPECT_GT(loads(slams, pose, stillWater(), 0.0, scratch).drag.force.z, 1.2 * without);
  pose.velocity.z = 3.0;
  EXPECT_NEAR(loads(slams, pose, stillWater(), 0.0, scratch).drag.force.z, -without,
              1e-9 * without);
}

WaterSurface groups(std::size_t count) {
  std::vector<Octave> octaves;
  for (std::size_t i = 0; i < count; ++i) {
    octaves.push_back(makeGroupOctave(0.3, 0.1 + 0.03 * static_cast<double>(i), 0.02,
                                      0.1 * static_cast<double>(i), 0.5));
  }
  return WaterSurface(WaveField(octaves, {.seed = 5}));
}

TEST(HullLoads, WavesShorterThanTheHullFeelsAreLeftOutAndTold) {
  const WaterSurface sea = groups(12);
  const HullModel hull = halfFloating(wigleyMesh(60.0, 8.0, 3.0, 3.0));
  LoadScratch scratch;
  const HullLoads cut = loads(hull, {}, sea, 1.0, scratch);
  EXPECT_EQ(hull.shortestWavelength(), 15.0);
  double variance = 0.0;
  for (const Octave& octave : sea.waves().octaves()) {
    if (dominantWavelength(octave) < 15.0) variance += 0.09;
  }
  ASSERT_GT(variance, 0.0);
  EXPECT_NEAR(cut.leftOut, std::sqrt(variance), 1e-12);
  EXPECT_TRUE(has(cut.status, SampleStatus::truncated));
  const HullLoads all = loads(hull, {}, sea, 1.0, scratch, {.shortestWavelength = 0.0});
  EXPECT_EQ(all.leftOut, 0.0);
  EXPECT_NE(all.buoyancy.force.z, cut.buoyancy.force.z);
}

// A launch has sailed ten seconds east; a small hull lies in its wake.
TEST(HullLoads, WakesOfOthersAreFeltAndTheHullsOwnIsNot) {
  WakeSystem system;
  const std::uint32_t launch = system.addVessel(HullFootprint::wigley(12.0, 3.5, 0.8));
  for (int i = 0; i <= 100; ++i) system.record(launch, {0.1 * i, {0.5 * i, 0.0}, 0.0, 1.0});
  system.advance(10.0, std::vector<WakeListener>{{{40.0, 20.0}, 5.0, 0}});
  WaterSurface water{WaveField({})};
  water.setDisturbances(system.feed());
  const HullModel hull = halfFloating(boxMesh(0.2, 0.1, 0.2, 0.1));
  HullPose pose;
  pose.position = {40.0, 6.0, 0.0};
  const double surface = water.sample({40.0, 6.0}, 10.0).height;
  ASSERT_GT(std::abs(surface), 0.005);
  ASSERT_LT(std::abs(surface), 0.1);
  LoadScratch scratch;
  const double still = loads(hull, pose, stillWater(), 10.0, scratch).buoyancy.force.z;
  const double lift = loads(hull, pose, water, 10.0, scratch).buoyancy.force.z - still;
  // Waves of 2 m lose a quarter of their pressure over its draft.
  EXPECT_GT(lift / (weightDensity * 0.2 * 0.1 * surface), 0.6);
  EXPECT_LT(lift / (weightDensity * 0.2 * 0.1 * surface), 1.1);
  EXPECT_EQ(loads(hull, pose, water, 10.0, scratch, {.ownWake = launch}).buoyancy.force.z, still);
}

TEST(HullLoads, GiveTheSameBitsAloneTogetherAndFromAnyScratch) {
  const WaterSurface sea = groups(12);
  const HullModel mesh = halfFloating(wigleyMesh(10.0, 1.5, 0.6, 0.5, 300));
  const HullModel columns = halfFloating(boxMesh(4.0, 2.0, 1.0, 0.5), LoadLevel::columns);
  std::vector<PlacedHull> hulls;
  for (int i = 0; i < 40; ++i) {
    HullPose pose;
    pose.position = {17.0 * i, -5.0 * i, 0.0};
    pose.velocity = {0.1 * i, 1.0, 0.0};
    hulls.push_back({i % 2 ? &mesh : &columns, pose, {}});
  }
  const SurfaceAtTime now = sea.at(3.0);
  std::vector<HullLoads> together(hulls.size());
  std::vector<LoadScratch> scratch(hulls.size());
  loadsInParallel(hulls, now, together, scratch);
  LoadScratch one;
  for (std::size_t i = 0; i < hulls.size(); ++i) {
    const HullLoads alone = loads(*hulls[i].model, hulls[i].pose, sea, 3.0, one);
    EXPECT_EQ(alone.total().force, together[i].total().force);
    EXPECT_EQ(alone.total().moment, together[i].total().moment);
  }
}

TEST(HullLoads, AllocateNothingOnceWarm) {
  const WaterSurface sea = groups(12);
  const HullModel mesh = halfFloating(wigleyMesh(10.0, 1.5, 0.6, 0.5));
  const HullModel columns = halfFloating(boxMesh(4.0, 2.0, 1.0, 0.5), LoadLevel::columns);
  LoadScratch scratch;
  for (const HullModel* hull : {&mesh, &columns}) {
    HullPose pose;
    pose.velocity.x = 1.0;
    double sum = loads(*hull, pose, sea, 0.0, scratch).buoyancy.force.z;
    const std::size_t before = test_support::allocationCount();
    for (int i = 1; i < 20; ++i) {
      pose.position.z = 0.1 * i - 1.0;
      sum += loads(*hull, pose, sea, 0.1 * i, scratch).buoyancy.force.z;
    }
    EXPECT_EQ(test_support::allocationCount(), before);
    EXPECT_GT(sum, 0.0);
  }
}

TEST(HullLoadsHard, PosesAndTimesThatAreNotFiniteGiveNanAndAStatus) {
  const HullModel hull = halfFloating(boxMesh(1.0, 1.0, 1.0, 0.5));
  const WaterSurface sea = groups(3);
  LoadScratch scratch;
  HullPose pose;
  pose.position.x = std::numeric_limits<double>::quiet_NaN();
  const HullLoads lost = loads(hull, pose, sea, 0.0, scratch);
  EXPECT_TRUE(std::isnan(lost.total().force.x));
  EXPECT_TRUE(has(lost.status, SampleStatus::notFinite));
  EXPECT_TRUE(std::isnan(loads(hull, {}, sea, NAN, scratch).total().force.z));
  pose.position.x = 1e13;
  EXPECT_TRUE(has(loads(hull, pose, sea, 0.0, scratch).status, SampleStatus::outOfRange));
  // And comes back.
  EXPECT_TRUE(std::isfinite(loads(hull, {}, sea, 0.0, scratch).total().force.z));
}

TEST(HullLoadsHard, HullsOutOfTheWaterFeelNothingAndUnderItTheirDisplacement) {
  const HullModel hull = halfFloating(sphereMesh(1.0));
  const WaterSurface sea = groups(6);
  LoadScratch scratch;
  HullPose pose;
  pose.position.z = 30.0;
  const HullLoads out = loads(hull, pose, sea, 2.0, scratch);
  EXPECT_EQ(out.total().force, glm::dvec3(0.0));
  EXPECT_EQ(out.submergedVolume, 0.0);
  pose.position.z = -60.0;
  const HullLoads under = loads(hull, pose, sea, 2.0, scratch);
  // What the longest wave (156 m) leaves at 60 m depth is k a e^(−kd) of the weight: 0.2 %.
  EXPECT_NEAR(under.buoyancy.force.z, weightDensity * 4.0 / 3.0 * pi,
              2e-3 * weightDensity * 4.0 / 3.0 * pi);
}

TEST(HullLoadsHard, PerlinSeasAndShallowTroughsAreTold) {
  const HullModel hull = halfFloating(boxMesh(1.0, 1.0, 1.0, 0.5));
  LoadScratch scratch;
  const WaterSurface perlin{WaveField({makePerlinOctave(0.3, 40.0, 0.0)})};
  const HullLoads hydrostatic = loads(hull, {}, perlin, 0.0, scratch);
  EXPECT_TRUE(has(hydrostatic.status, SampleStatus::noKinematics));
  EXPECT_TRUE(std::isfinite(hydrostatic.total().force.z));
  const WaterSurface dry{WaveField({makeRegularWave(2.0, 0.1, 0.0, pi, 1.0)}, {.depth = 1.0})};
  const HullLoads aground = loads(hull, {}, dry, 0.0, scratch);
  EXPECT_TRUE(has(aground.status, SampleStatus::belowBed));
  EXPECT_TRUE(std::isnan(aground.total().force.z));
}

TEST(HullLoadsHard, ThinPlatesCubesOfAMillimetreAndTankersKeepArchimedes) {
  LoadScratch scratch;
  for (const glm::dvec3 size :
       {glm::dvec3(2.0, 1.0, 1e-3), glm::dvec3(1e-3), glm::dvec3(400.0, 60.0, 30.0)}) {
    const TriangleMesh mesh = boxMesh(size.x, size.y, size.z, 0.5 * size.z);
    for (const double part : {0.01, 0.5, 0.99}) {
      const double mass = part * seaWaterDensity * size.x * size.y * size.z;
      const HullModel hull = model(mesh, mass);
      HullPose pose;
      pose.position.z = hull.restHeight();
      EXPECT_NEAR(hull.restHeight(), (0.5 - part) * size.z, 1e-9 * size.z);
      EXPECT_NEAR(loads(hull, pose, stillWater(), 0.0, scratch).total().force.z,
                  mass * standardGravity, 1e-9 * mass * standardGravity);
    }
  }
}

TEST(HullModelHard, BadMeshesAndMassesAreRefusedWithTheirReason) {
  TriangleMesh mesh = boxMesh(1.0, 1.0, 1.0, 0.5);
  for (const double mass : {0.0, -1.0, 2000.0, static_cast<double>(NAN)}) {
    EXPECT_THROW(model(mesh, mass), InputError) << mass;
  }
  // Turned round without a word: which way is out is not in doubt.
  EXPECT_GT(model(turnedInsideOut(mesh), 500.0).atRest().volume, 0.0);
  TriangleMesh flipped = mesh;
  std::swap(flipped.triangles[3].x, flipped.triangles[3].y);
  EXPECT_THROW(model(flipped, 500.0), InputError);
  mesh.triangles.pop_back();
  try {
    model(mesh, 500.0);
    FAIL();
  } catch (const InputError& fault) {
    EXPECT_NE(std::string(fault.what()).find("hole"), std::string::npos);
  }
}

}  // namespace
}  // namespace seaway
