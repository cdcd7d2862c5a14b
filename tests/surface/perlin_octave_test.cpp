#include "surface/field/perlin_octave.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "surface/angles.h"
#include "surface/dispersion.h"
#include "surface/field/perlin_spectrum.h"

namespace seaway {
namespace {

const Octave octave = makePerlinOctave(0.3, 20.0, 0.7);
const PerlinOctave noise(octave, 7, 0, {0.0, 0.0});

OctaveSample at(const PerlinOctave& evaluator, glm::dvec2 point, double t) {
  return evaluator.sample(point, evaluator.at(t));
}

TEST(PerlinOctave, DriftsAndBoilsAsTheWaveAtItsSpectralPeak) {
  const double k = 2.0 * pi * perlinPeakCyclesPerCell / 20.0;
  EXPECT_DOUBLE_EQ(octave.driftSpeed, phaseSpeed(k));
  EXPECT_DOUBLE_EQ(octave.boilTime, 0.5 * 2.0 * pi / angularFrequency(k));
}

TEST(PerlinOctave, StandardDeviationIsTheOneAskedForAtEveryInstant) {
  // Instants at fractions 0, ¼, ½, ¾ of a boil time: without variance-preserving blending the one
  // in the middle would be 30 % low.
  for (int quarter = 0; quarter < 4; ++quarter) {
    double sum = 0.0, squares = 0.0;
    constexpr int side = 400;
    for (int j = 0; j < side; ++j) {
      for (int i = 0; i < side; ++i) {
        const double height =
            at(noise, {i * 13.7, j * 13.7}, 0.25 * quarter * octave.boilTime).height;
        sum += height;
        squares += height * height;
      }
    }
    const double count = side * side;
    // Neighbouring samples share a cell or two: about 40 000 independent ones, 4 σ of √(1/(2n)).
    EXPECT_NEAR(std::sqrt(squares / count) / 0.3, 1.0, 0.015);
    EXPECT_NEAR(sum / count, 0.0, 0.004);
  }
}

TEST(PerlinOctave, SlopesAndVelocityAreTheDerivativesOfHeight) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> uniform(-500.0, 500.0);
  constexpr double step = 1e-4;
  for (int n = 0; n < 200; ++n) {
    const glm::dvec2 p(uniform(random), uniform(random));
    const double t = uniform(random);
    const OctaveSample sample = at(noise, p, t);
    const glm::dvec2 dx(step, 0.0), dy(0.0, step);
    // Central differences: error step² · third derivative ≈ 1e-8, rounding 1e-16/1e-4.
    EXPECT_NEAR(sample.slope.x,
                (at(noise, p + dx, t).height - at(noise, p - dx, t).height) / (2 * step), 1e-7);
    EXPECT_NEAR(sample.slope.y,
                (at(noise, p + dy, t).height - at(noise, p - dy, t).height) / (2 * step), 1e-7);
    EXPECT_NEAR(sample.verticalVelocity,
                (at(noise, p, t + step).height - at(noise, p, t - step).height) / (2 * step), 1e-6);
  }
}

TEST(PerlinOctave, CurrentCarriesTheOctaveAlong) {
  const glm::dvec2 current(1.5, -0.5);
  const PerlinOctave carried(octave, 7, 0, current);
  const glm::dvec2 p(31.0, -7.0);
  EXPECT_NEAR(at(carried, p + current * 12.0, 12.0).height, at(noise, p, 12.0).height, 1e-12);
}

TEST(PerlinOctave, SeedsAndIndicesGiveUnrelatedOctaves) {
  const PerlinOctave otherSeed(octave, 8, 0, {0.0, 0.0}), otherIndex(octave, 7, 1, {0.0, 0.0});
  double bySeed = 0.0, byIndex = 0.0;
  constexpr int count = 40000;
  for (int n = 0; n < count; ++n) {
    const glm::dvec2 p(n % 200 * 23.0, n / 200 * 23.0);
    const double height = at(noise, p, 0.0).height;
    bySeed += height * at(otherSeed, p, 0.0).height / count;
    byIndex += height * at(otherIndex, p, 0.0).height / count;
  }
  EXPECT_NEAR(bySeed / 0.09, 0.0, 5.0 / std::sqrt(count));  // 5 σ
  EXPECT_NEAR(byIndex / 0.09, 0.0, 5.0 / std::sqrt(count));
}

TEST(PerlinOctave, NeverExceedsItsStatedPeak) {
  double largest = 0.0;
  for (int n = 0; n < 200000; ++n)
    largest = std::max(largest, std::abs(at(noise, {n * 1.37, n * 0.71}, n * 0.1).height));
  EXPECT_LE(largest, 0.3 * PerlinOctave::peakFactor());
  EXPECT_GE(largest, 0.5 * 0.3 * PerlinOctave::peakFactor());  // and the bound is not idle
}

TEST(PerlinOctaveHard, HeightSlopeAndVelocityAreContinuousAcrossCellsAndSlices) {
  constexpr double step = 1e-9;
  for (int n = 0; n < 20000; ++n) {
    const glm::dvec2 p(n * 0.05, n * 0.03);  // crosses hundreds of lattice lines
    const double t = n * 0.01;               // and tens of slices
    const OctaveSample a = at(noise, p, t), b = at(noise, p + glm::dvec2(step), t + step);
    // Lipschitz constants (slope < 0.2, its derivative < 0.1, accelerations < 3) times the step.
    EXPECT_NEAR(a.height, b.height, 3e-9);
    EXPECT_NEAR(a.slope.x, b.slope.x, 3e-9);
    EXPECT_NEAR(a.slope.y, b.slope.y, 3e-9);
    EXPECT_NEAR(a.verticalVelocity, b.verticalVelocity, 1e-8);
  }
}

TEST(PerlinOctaveHard, FarAwayNeighbouringDoublesDifferByNoMoreThanTheStatedBound) {
  Octave still = makePerlinOctave(0.3, 20.0, 0.0);
  still.driftSpeed = 0.0;
  const PerlinOctave evaluator(still, 7, 0, {0.0, 0.0});
  for (const double far : {1e5, 1e7, 1e8}) {
    const double spacing = std::nextafter(far, INFINITY) - far;
    const double here = at(evaluator, {far, -far}, 0.0).height;
    const double next = at(evaluator, {far + spacing, -far}, 0.0).height;
    EXPECT_TRUE(std::isfinite(here));
    EXPECT_LE(std::abs(next - here), 2.0 * evaluator.roundingBound(far));
  }
}

TEST(PerlinOctaveHard, LateTimesCostNoPrecision) {
  // Drift and boiling over whole cells: the same octave a billion seconds on, moved back by hand.
  Octave moving = makePerlinOctave(0.3, 16.0, 0.0);
  moving.driftSpeed = 8.0;
  moving.boilTime = 4.0;
  const PerlinOctave evaluator(moving, 7, 0, {0.0, 0.0});
  const double late = 1e9;
  const OctaveSample a = at(evaluator, {8.0 * late + 3.0, 5.0}, late);
  const OctaveSample b = at(evaluator, {8.0 * (late + 1e-3) + 3.0, 5.0}, late + 1e-3);
  EXPECT_NEAR(a.height, b.height, 1e-3);  // only boiled for a millisecond; 8e9 m hold 1e-6 m
}

}  // namespace
}  // namespace seaway
