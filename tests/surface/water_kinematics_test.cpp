#include "surface/water_kinematics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <random>
#include <string>

#include "surface/angles.h"
#include "surface/dispersion.h"
#include "surface/field/kernels/field_blocks.h"
#include "tests/support/allocation_counter.h"

namespace seaway {
namespace {

WaterKinematics at(const WaveField& waves, glm::dvec3 point, double t) {
  WaterKinematics result;
  sampleKinematicsReference(waves, std::span(&point, 1), t, std::span(&result, 1));
  return result;
}

double heightAt(const WaveField& waves, glm::dvec2 point, double t) {
  SurfaceSample sample;
  waves.sampleReference(std::span(&point, 1), t, std::span(&sample, 1));
  return sample.height;
}

WaveField windSea(double depth, double each = 0.12) {
  std::vector<Octave> octaves;
  for (int i = 0; i < 8; ++i) {
    octaves.push_back(makeGroupOctave(each, 0.1 + 0.04 * i, 0.02, 0.3 * i - 1.0, 0.5, depth));
  }
  return WaveField(octaves, {.seed = 3, .depth = depth, .current = {0.4, 0.2}});
}

TEST(WaterKinematics, ARegularDeepWaveFollowsTheClosedForms) {
  const double omega = 2.0 * pi * 0.1, k = waveNumber(omega), a = 0.5;
  const WaveField wave({makeRegularWave(a, 0.1, 0.0)});
  // Crest at the anchor at time 0: u = ωa e^{k(z − η)}, w = 0, du/dt = 0, dw/dt = −ω²a e^{…}.
  for (const double z : {0.5, 0.0, -3.0, -20.0}) {
    const WaterKinematics water = at(wave, {0.0, 0.0, z}, 0.0);
    const double decay = std::exp(k * (z - a));
    EXPECT_NEAR(water.velocity.x, omega * a * decay, 1e-12);
    EXPECT_NEAR(water.velocity.z, 0.0, 1e-12);
    EXPECT_NEAR(water.acceleration.z, -omega * omega * a * decay, 1e-12);
    EXPECT_NEAR(water.dynamicPressure, 1026.0 * 9.80665 * a * decay, 1e-8);
  }
}

TEST(WaterKinematics, AtTheBedOfShallowWaterNothingMovesUpAndVelocityIsTheClosedForm) {
  const double depth = 4.0, omega = 2.0 * pi * 0.1, k = waveNumber(omega, depth), a = 0.3;
  const WaveField wave({makeRegularWave(a, 0.1, 0.0, 0.0, depth)}, {.depth = depth});
  const WaterKinematics bed = at(wave, {0.0, 0.0, -depth}, 0.0);
  EXPECT_NEAR(bed.velocity.x, a * omega / std::sinh(k * depth), 1e-12);
  EXPECT_EQ(at(wave, {3.0, 0.0, -depth}, 1.0).velocity.z, 0.0);
}

TEST(WaterKinematics, PressureVanishesAtTheSurfaceAndGrowsDownwards) {
  for (const double depth : {6.0, deepWater}) {
    const WaveField waves = windSea(depth);
    for (int n = 0; n < 200; ++n) {
      const glm::dvec2 place(n * 7.3, n * -3.1);
      const double t = n * 0.9, surface = heightAt(waves, place, t);
      EXPECT_NEAR(at(waves, {place, surface}, t).pressure, 0.0, 1e-8);
      double above = 0.0;
      for (double z = surface - 0.25; z > std::max(-depth, -12.0); z -= 0.25) {
        const double pressure = at(waves, {place, z}, t).pressure;
        EXPECT_GT(pressure, above);
        above = pressure;
      }
    }
  }
}

TEST(WaterKinematics, SurfaceValuesAreThoseOfTheSamples) {
  const WaveField waves = windSea(9.0);
  for (int n = 0; n < 50; ++n) {
    const glm::dvec2 place(n * 17.0, n * 5.0);
    SurfaceSample sample;
    waves.sampleReference(std::span(&place, 1), 2.0 * n, std::span(&sample, 1),
                          {.orbitalVelocity = true});
    const WaterKinematics water = at(waves, {place, sample.height}, 2.0 * n);
    EXPECT_NEAR(water.velocity.x, sample.orbitalVelocity.x, 1e-12);
    EXPECT_NEAR(water.velocity.y, sample.orbitalVelocity.y, 1e-12);
    EXPECT_NEAR(water.velocity.z, sample.orbitalVelocity.z, 1e-12);
  }
}

TEST(WaterKinematics, ContinuityHoldsToTheOrderOfTheTheory) {
  // ∇·u of linear waves vanishes; stretching and the octaves' bandwidth leave terms of the order of
  // steepness and relative bandwidth (here 0.05 and 0.1) of ∂u/∂x.
  const double depth = 30.0;
  const WaveField waves = windSea(depth);
  constexpr double step = 1e-3;
  double divergence = 0.0, gradient = 0.0;
  for (int n = 0; n < 400; ++n) {
    const glm::dvec3 p(n * 13.0, n * -7.0, -3.0);
    const auto velocity = [&](glm::dvec3 offset) {
      return at(waves, p + offset, 1.0 * n).velocity;
    };
    const double ux = (velocity({step, 0, 0}).x - velocity({-step, 0, 0}).x) / (2 * step);
    const double vy = (velocity({0, step, 0}).y - velocity({0, -step, 0}).y) / (2 * step);
    const double wz = (velocity({0, 0, step}).z - velocity({0, 0, -step}).z) / (2 * step);
    divergence += std::pow(ux + vy + wz, 2);
    gradient += ux * ux + vy * vy + wz * wz;
  }
  EXPECT_LT(std::sqrt(divergence / gradient), 0.2);
}

/// Points from the bed (or 40 m down) to above the crests, and some that are no places at all.
std::vector<glm::dvec3> pointsInTheWater(double depth, double reach) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> across(-reach, reach), up(-std::min(depth, 40.0), 0.6);
  std::vector<glm::dvec3> points;
  for (int i = 0; i < 1000; ++i) points.push_back({across(random), across(random), up(random)});
  points.push_back({NAN, 0.0, 0.0});
  points.push_back({0.0, 0.0, NAN});
  return points;
}

class WaterKinematicsKernels : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    if (!forceKernelTarget(GetParam())) GTEST_SKIP() << "no " << GetParam() << " on this machine";
  }
  void TearDown() override { forceKernelTarget(""); }
};

TEST_P(WaterKinematicsKernels, AgreeWithTheReference) {
  for (const double depth : {0.7, 6.0, 50.0, deepWater}) {
    const WaveField waves = windSea(depth, depth < 1.0 ? 0.02 : 0.12);
    for (const double reach : {1e3, 1e7}) {
      const auto points = pointsInTheWater(depth, reach);
      std::vector<WaterKinematics> fast(points.size()), truth(points.size());
      sampleKinematics(waves.at(9.5), points, fast);
      sampleKinematicsReference(waves, points, 9.5, truth);
      // 1e-5 σω of velocity, σω² of acceleration, σρg of pressure, with the highest ω coth kd of
      // the field; beside that the spacing of doubles at `reach` times the wave number.
      const double sigma = waves.standardDeviation();
      const double omega = 2.0 * pi * 0.38 / std::tanh(std::min(1.0, 0.04 * depth));
      const double allowed = 1e-5 * sigma + 8.0 * (std::nextafter(reach, 1e9) - reach);
      for (std::size_t i = 0; i < points.size(); ++i) {
        // Where the heights' rounding decides between water and air both answers are right.
        if (std::abs(points[i].z - truth[i].surfaceHeight) < 1e-5) continue;
        ASSERT_EQ(fast[i].status, truth[i].status) << i;
        if (std::isnan(truth[i].pressure)) continue;
        EXPECT_LT(glm::distance(fast[i].velocity, truth[i].velocity), allowed * omega);
        EXPECT_LT(glm::distance(fast[i].acceleration, truth[i].acceleration),
                  allowed * omega * omega);
        EXPECT_NEAR(fast[i].pressure, truth[i].pressure, allowed * 1026.0 * 9.81);
      }
    }
  }
}

TEST_P(WaterKinematicsKernels, GiveTheSameBitsForAnyBatch) {
  const WaveField waves = windSea(9.0);
  const FieldAtTime now = waves.at(3.0);
  const auto points = pointsInTheWater(9.0, 1e3);
  std::vector<WaterKinematics> whole(points.size()), part(points.size());
  sampleKinematics(now, points, whole);
  for (std::size_t i = 0; i < points.size(); i += 3) {
    const std::size_t n = std::min<std::size_t>(3, points.size() - i);
    sampleKinematics(now, std::span(points).subspan(i, n), std::span(part).subspan(i, n));
  }
  EXPECT_EQ(std::memcmp(whole.data(), part.data(), whole.size() * sizeof(WaterKinematics)), 0);
}

TEST_P(WaterKinematicsKernels, AllocateNothing) {
  const WaveField waves = windSea(9.0);
  const FieldAtTime now = waves.at(3.0);
  const auto points = pointsInTheWater(9.0, 1e3);
  std::vector<WaterKinematics> out(points.size());
  const std::size_t before = test_support::allocationCount();
  sampleKinematics(now, points, out);
  EXPECT_EQ(test_support::allocationCount(), before);
}

std::string nameOfTarget(const testing::TestParamInfo<const char*>& info) { return info.param; }
INSTANTIATE_TEST_SUITE_P(Targets, WaterKinematicsKernels, testing::Values("AVX3", "AVX2", "SSE4"),
                         nameOfTarget);

TEST(WaterKinematics, WavesShorterThanACutOffMoveNoWater) {
  const WaveField both({makeRegularWave(0.5, 0.1, 0.0), makeRegularWave(0.1, 0.5, 0.0)});
  const WaveField longOnly({makeRegularWave(0.5, 0.1, 0.0)});
  const glm::dvec3 point(3.0, 1.0, -1.0);
  WaterKinematics cut, alone;
  sampleKinematics(both.at(1.0), std::span(&point, 1), std::span(&cut, 1),
                   {.shortestWavelength = 20.0});
  sampleKinematics(longOnly.at(1.0), std::span(&point, 1), std::span(&alone, 1));
  EXPECT_EQ(cut.pressure, alone.pressure);
  EXPECT_EQ(cut.velocity, alone.velocity);
  EXPECT_EQ(statusText(cut.status), "truncated");
}

TEST(WaterKinematicsHard, FiniteFromBedToCrestInAnyDepthAndForTheShortestWaves) {
  for (const double depth : {0.5, 10.0, 1000.0, deepWater}) {
    std::vector<Octave> octaves;
    for (const double frequency : {0.02, 0.1, 1.0, 5.0}) {
      octaves.push_back(makeGroupOctave(0.02 / frequency > 0.1 ? 0.1 : 0.02, frequency,
                                        0.2 * frequency, 0.0, 0.5, depth));
    }
    const WaveField waves(octaves, {.depth = depth});
    for (int n = 0; n < 100; ++n) {
      const glm::dvec2 place(n * 3.0, n);
      const double surface = heightAt(waves, place, n);
      const double bed = std::isinf(depth) ? surface - 5000.0 : -depth;
      if (surface <= bed) continue;
      for (int level = 0; level <= 10; ++level) {
        const double z = level == 10 ? surface : bed + (surface - bed) * level / 10.0;
        const WaterKinematics water = at(waves, {place, z}, n);
        EXPECT_EQ(statusText(water.status), "ok") << depth << ' ' << z;
        EXPECT_TRUE(std::isfinite(glm::length(water.velocity) + glm::length(water.acceleration) +
                                  water.pressure));
        EXPECT_LT(glm::length(water.velocity), 20.0);
      }
    }
  }
}

TEST(WaterKinematicsHard, WhereThereIsNoWaterTheStatusSaysSo) {
  const WaveField waves({makeRegularWave(2.0, 0.1, 0.0, 0.0, 1.5)}, {.depth = 1.5});
  EXPECT_EQ(statusText(at(waves, {0.0, 0.0, 3.0}, 0.0).status), "above_surface");
  EXPECT_EQ(statusText(at(waves, {0.0, 0.0, -1.6}, 0.0).status), "below_bed");
  EXPECT_EQ(statusText(at(waves, {0.0, 0.0, -1.4}, 5.0).status), "below_bed");  // trough of −2 m
  EXPECT_TRUE(std::isnan(at(waves, {0.0, 0.0, 3.0}, 0.0).pressure));
  EXPECT_EQ(statusText(at(waves, {NAN, 0.0, 0.0}, 0.0).status), "not_finite");
  const WaveField perlin({makePerlinOctave(0.3, 10.0, 0.0)});
  EXPECT_EQ(statusText(at(perlin, {0.0, 0.0, -2.0}, 0.0).status), "no_kinematics");
}

}  // namespace
}  // namespace seaway
