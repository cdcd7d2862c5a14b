#include "render/grid_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace seaway::render {
namespace {

// A regular wave of 1 m, 1 standard deviation, that goes east, on a plain grid of 11 by 11 vertices
// about the camera's foot point.
struct Drawn {
  explicit Drawn(double wavelength, double spacing)
      : waves({makeRegularWave(std::numbers::sqrt2,
                               std::sqrt(9.80665 / (2.0 * std::numbers::pi * wavelength)), 0.0)}),
        layout(naiveLayout(waves, 10.0 * spacing, {11, 11})),
        error(waves, layout) {}
  WaveField waves;
  GridLayout layout;
  GridError error;
};

TEST(GridError, IsNoneAtVerticesAndThatOfStraightLinesBetween) {
  const Drawn drawn(100.0, 10.0);
  const double half = std::numbers::pi * 10.0 / 100.0;  // phase of half a cell
  EXPECT_NEAR(drawn.error.standardDeviationAt({0.0, 0.0}), 0.0, 1e-9);
  EXPECT_NEAR(drawn.error.standardDeviationAt({-20.0, 30.0}), 0.0, 1e-9);
  EXPECT_NEAR(drawn.error.standardDeviationAt({5.0, 0.0}), 1.0 - std::cos(half), 1e-9);
  // Along its crests a wave is straight.
  EXPECT_NEAR(drawn.error.standardDeviationAt({0.0, 5.0}), 0.0, 1e-9);
  EXPECT_NEAR(drawn.error.standardDeviationAt({35.0, -5.0}), 1.0 - std::cos(half), 1e-9);
}

TEST(GridError, IsAllOfWavesThatAGridCannotCarry) {
  for (const glm::dvec2 place : {glm::dvec2(0.0), glm::dvec2(3.0, 1.0)}) {
    EXPECT_NEAR(Drawn(19.0, 10.0).error.standardDeviationAt(place), 1.0, 1e-12);
  }
}

/// rms over the grid, about the foot point, of straight lines between vertices against the waves
/// themselves, and of what is foretold of it.
struct Measured {
  double foretold = 0.0, found = 0.0;  // m
};
Measured measured(const WaveField& waves, const GridLayout& layout) {
  const GridError error(waves, layout);
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  Measured sum;
  constexpr int places = 20000;
  for (int i = 0; i < places; ++i) {
    const int row = static_cast<int>(part(random) * (layout.size.y - 1));
    const int column = static_cast<int>(part(random) * (layout.size.x - 1));
    const double x = part(random), y = part(random), time = 1e4 * part(random);
    const auto at = [&](int down, int along) {
      return waves.at(time).sample(layout.place(row + down, column + along)).height;
    };
    const double drawn =
        x + y <= 1.0 ? at(0, 0) * (1.0 - x - y) + at(0, 1) * x + at(1, 0) * y
                     : at(1, 1) * (x + y - 1.0) + at(0, 1) * (1.0 - y) + at(1, 0) * (1.0 - x);
    const glm::dvec2 corner = layout.place(row, column);
    const glm::dvec2 place = corner + x * (layout.place(row, column + 1) - corner) +
                             y * (layout.place(row + 1, column) - corner);
    sum.found += std::pow(drawn - waves.at(time).sample(place).height, 2) / places;
    sum.foretold += std::pow(error.standardDeviationAt(place), 2) / places;
  }
  return {std::sqrt(sum.foretold), std::sqrt(sum.found)};
}

double frequencyOf(double wavelength) {
  return std::sqrt(9.80665 / (2.0 * std::numbers::pi * wavelength));
}

// Along one diagonal quads are cut, along the other not: waves that go either way differ.
TEST(GridError, IsThatOfWavesDrawnInTriangles) {
  double last = 0.0;
  for (const double toward : {0.25 * std::numbers::pi, 0.75 * std::numbers::pi}) {
    const WaveField waves({makeRegularWave(1.0, frequencyOf(60.0), toward)});
    const Measured rms = measured(waves, naiveLayout(waves, 400.0, {41, 41}));
    EXPECT_NEAR(rms.found, rms.foretold, 0.03 * rms.foretold);  // 20 000 places
    EXPECT_GT(std::abs(rms.foretold - last), 0.2 * rms.foretold);
    last = rms.foretold;
  }
}

// Octaves have more wave numbers than the few that stand for them here.
TEST(GridError, IsThatOfOctavesOfEitherKind) {
  for (const double spacing : {1.5, 4.0}) {
    for (const Octave& octave :
         {makeGroupOctave(1.0, frequencyOf(40.0), 0.2 * frequencyOf(40.0), 0.4, 0.5),
          makePerlinOctave(1.0, 24.0, 0.4)}) {
      const WaveField waves({octave});
      const Measured rms = measured(waves, naiveLayout(waves, 40.0 * spacing, {41, 41}));
      EXPECT_NEAR(rms.found, rms.foretold, 0.1 * rms.foretold) << spacing;
    }
  }
}

TEST(GridErrorHard, OfNoWavesThereIsNone) {
  const WaveField still(std::vector<Octave>{});
  const GridLayout layout = naiveLayout(still, 100.0, {2, 2});
  EXPECT_EQ(GridError(still, layout).standardDeviationAt({1e6, -1e6}), 0.0);
}

TEST(GridErrorHard, PlacesBesideAGridAreAsItsBorder) {
  const Drawn drawn(100.0, 10.0);
  EXPECT_EQ(drawn.error.standardDeviationAt({1e5, 5.0}),
            drawn.error.standardDeviationAt({50.0, 5.0}));
  EXPECT_EQ(drawn.error.standardDeviationAt({5.0, -1e5}),
            drawn.error.standardDeviationAt({5.0, -50.0}));
}

}  // namespace
}  // namespace seaway::render
