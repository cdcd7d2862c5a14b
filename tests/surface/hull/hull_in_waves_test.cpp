#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "surface/dispersion.h"
#include "surface/disturbance/wake_system.h"
#include "surface/hull/hull_loads.h"
#include "tests/surface/hull/hull_cases.h"

namespace seaway {
namespace {

using namespace test;

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

}  // namespace
}  // namespace seaway
