#include "render/grid_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

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
  EXPECT_NEAR(drawn.error.standardDeviationAt({5.0, 0.0}), 1.0 - std::cos(half), 1e-4);
  // Along its crests a wave is straight.
  EXPECT_NEAR(drawn.error.standardDeviationAt({0.0, 5.0}), 0.0, 1e-9);
  EXPECT_NEAR(drawn.error.standardDeviationAt({35.0, -5.0}), 1.0 - std::cos(half), 1e-4);
}

TEST(GridError, IsAllOfWavesThatAGridCannotCarry) {
  for (const glm::dvec2 place : {glm::dvec2(0.0), glm::dvec2(3.0, 1.0)}) {
    EXPECT_NEAR(Drawn(19.0, 10.0).error.standardDeviationAt(place), 1.0, 1e-12);
  }
}

TEST(GridErrorHard, OfNoWavesThereIsNone) {
  const WaveField still(std::vector<Octave>{});
  const GridLayout layout = naiveLayout(still, 100.0, {2, 2});
  EXPECT_EQ(GridError(still, layout).standardDeviationAt({1e6, -1e6}), 0.0);
}

TEST(GridErrorHard, PlacesBesideAGridAreAsItsBorder) {
  const Drawn drawn(100.0, 10.0);
  for (const glm::dvec2 place : {glm::dvec2(1e5, 0.0), glm::dvec2(0.0, -1e5), glm::dvec2(50.0)}) {
    const double error = drawn.error.standardDeviationAt(place);
    EXPECT_GE(error, 0.0);
    EXPECT_LT(error, 0.1) << place.x << ' ' << place.y;
  }
}

}  // namespace
}  // namespace seaway::render
