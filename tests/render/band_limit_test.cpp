#include "render/band_limit.h"

#include <gtest/gtest.h>

#include "tests/render/seas.h"

namespace seaway::render {
namespace {

TEST(BandLimit, CoxMunkTotalIsAsPublished) {
  EXPECT_NEAR(coxMunkMeanSquareSlope(0.0), 0.003, 1e-12);
  EXPECT_NEAR(coxMunkMeanSquareSlope(10.0), 0.0542, 1e-12);
}

TEST(BandLimit, FineGridsCarryAllWavesAndCoarseOnesNone) {
  const WaterSurface water = test::moderateSea();
  const BandLimit limit(water.waves());
  const auto fine = limit.planFor(0.01);
  EXPECT_NEAR(fine.missingSlope, 0.0, 1e-12);
  const auto coarse = limit.planFor(1e4);
  EXPECT_EQ(coarse.weight, 0.0);
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
