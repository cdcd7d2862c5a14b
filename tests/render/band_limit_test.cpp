#include "render/band_limit.h"

#include <gtest/gtest.h>

#include "tests/render/seas.h"

namespace seaway::render {
namespace {

TEST(BandLimit, MeanSquareSlopeOfAnOctaveIsThatOfItsSampledSlopes) {
  const Octave octave = makePerlinOctave(0.3, 7.0, 0.5);
  const WaterSurface water(WaveField({octave}));
  double sum = 0.0;
  constexpr int side = 300;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const glm::dvec2 slope = water.sample({x * 2.7, y * 2.9}, 0.1 * x).slope;
      sum += slope.x * slope.x + slope.y * slope.y;
    }
  }
  // About 13 000 independent cells: sampling error near 1 %; 4 % is 4 of those deviations.
  EXPECT_NEAR(sum / (side * side) / meanSquareSlope(octave), 1.0, 0.04);
}

TEST(BandLimit, CoxMunkTotalIsAsPublished) {
  EXPECT_NEAR(coxMunkMeanSquareSlope(0.0), 0.003, 1e-12);
  EXPECT_NEAR(coxMunkMeanSquareSlope(10.0), 0.0542, 1e-12);
}

TEST(BandLimit, FineGridsCarryAllWavesAndCoarseOnesNone) {
  const WaterSurface water = test::moderateSea();
  const BandLimit limit(water.waves());
  const auto fine = limit.planFor(0.01);
  EXPECT_EQ(fine.kept, water.waves().octaves().size());
  EXPECT_NEAR(fine.missingSlope, 0.0, 1e-12);
  const auto coarse = limit.planFor(1e4);
  EXPECT_EQ(coarse.fading, 0u);
  EXPECT_NEAR(coarse.missingSlope, limit.totalSlope(), 1e-12);
}

TEST(BandLimit, MissingSlopeGrowsWithoutJumpsAsTheGridCoarsens) {
  const WaterSurface water = test::moderateSea();
  const BandLimit limit(water.waves());
  double before = 0.0;
  for (double spacing = 0.05; spacing < 200.0; spacing *= 1.01) {
    const double missing = limit.planFor(spacing).missingSlope;
    EXPECT_GE(missing, before - 1e-12) << spacing;
    EXPECT_LE(missing, before + 0.03 * limit.totalSlope()) << spacing;
    before = missing;
  }
}

}  // namespace
}  // namespace seaway::render
