#include "render/band_limit.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

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

TEST(BandLimit, LeanIsThatOfTheSlopesSampled) {
  const WaterSurface water = test::groupSea(0.5, 3.5);
  glm::dvec2 sum(0.0);
  double squares = 0.0;
  for (int i = 0; i < 40000; ++i) {
    const glm::dvec2 s = water.at(0.37 * i).waves().sample({61.7 * i, 43.1 * (i % 211)}).slope;
    sum += glm::dvec2(s.x * s.x - s.y * s.y, 2.0 * s.x * s.y);
    squares += glm::dot(s, s);
  }
  // Waves of 40 000 places are independent: 1 % of sampling error.
  EXPECT_LT(glm::length(sum / squares - BandLimit(water.waves()).lean()), 0.03);
}

TEST(BandLimit, LeanIsOneForOneDirectionAndNoneForAllOrNoWaves) {
  const WaveField regular({makeRegularWave(0.2, 0.25, 0.7)});
  const glm::dvec2 lean = BandLimit(regular).lean();
  EXPECT_LT(glm::length(lean - unitVector(1.4)), 1e-12);
  EXPECT_EQ(glm::length(BandLimit(test::moderateSea().waves()).lean()), 0.0);  // Perlin octaves
  EXPECT_EQ(glm::length(BandLimit(test::stillSea().waves()).lean()), 0.0);
}

}  // namespace
}  // namespace seaway::render
