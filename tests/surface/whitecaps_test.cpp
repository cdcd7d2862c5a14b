#include "surface/whitecaps.h"

#include <gtest/gtest.h>

#include <cmath>

#include "surface/fit/octave_fit.h"
#include "surface/spectra/families.h"
#include "tests/support/random_points.h"

namespace seaway {
namespace {

WaveField seaOf(double height, double period) {
  const OctaveFit fit = fitGroupOctaves(jonswap({height, period, 3.3}));
  EXPECT_TRUE(fit.summary.usable);
  return WaveField(fit.octaves, {.seed = 3});
}

TEST(Whitecaps, CoverGrowsWithTheWindAsMeasured) {
  // Monahan & O'Muircheartaigh's own curve at round winds.
  EXPECT_NEAR(whitecapCover(5.0), 0.00093, 0.00001);
  EXPECT_NEAR(whitecapCover(10.0), 0.0099, 0.0001);
  EXPECT_NEAR(whitecapCover(20.0), 0.105, 0.001);
  EXPECT_EQ(whitecapCover(0.0), 0.0);
  EXPECT_EQ(whitecapCover(-3.0), 0.0);
  EXPECT_EQ(whitecapCover(100.0), 1.0);
}

TEST(Whitecaps, MeanCoverOfASeaIsWhatTheWindAsksFor) {
  const WaveField waves = seaOf(3.0, 9.0);
  // Over 150 km and many hours: some 10⁶ independent places.
  const auto points = test_support::randomPoints(400'000, 75e3);
  std::vector<SurfaceSample> samples(points.size());
  waves.sample(points, 500.0, samples);
  for (const double wind : {5.0, 8.0, 12.0, 18.0, 25.0}) {
    const WhitecapRule rule(waves, wind);
    double sum = 0.0;
    for (const SurfaceSample& sample : samples) sum += rule.cover(sample.height, sample.slope);
    // A sum of few octaves has thinner tails than a Gaussian; steep water adds a little; of a cover
    // of 1e-3 some 400 white points are counted, to 5 %.
    const double tolerance = wind < 8.0 ? 0.25 : 0.15;
    EXPECT_NEAR(sum / points.size() / whitecapCover(wind), 1.0, tolerance) << wind;
  }
}

TEST(Whitecaps, AreOnCrestsAndAheadOfThemAndFoamIsBehind) {
  const WaveField waves = seaOf(3.0, 9.0);
  const WhitecapRule rule(waves, 15.0);
  const double sigma = waves.standardDeviation(), slope = 1.0 / rule.perSlope;
  const auto at = [&](double height, double ahead) {
    return rule.cover(height * sigma, -ahead * slope * rule.toward);
  };
  EXPECT_GT(at(2.2, 1.2), at(2.2, -1.2));  // it breaks ahead of the crest
  EXPECT_GT(at(0.5, -2.2), at(0.5, 1.5));  // and leaves foam behind
  EXPECT_EQ(at(-2.0, 0.0), 0.0);
  EXPECT_EQ(at(0.0, 0.0), 0.0);
}

TEST(Whitecaps, SteepWaterIsWhiteWhateverTheWind) {
  const WhitecapRule calm(WaveField({}), 0.0);
  EXPECT_EQ(calm.cover(0.5, {0.54, 0.0}), 0.0);
  EXPECT_EQ(calm.cover(0.5, {0.0, -0.86}), 1.0);
  EXPECT_EQ(calm.cover(10.0, {0.0, 0.0}), 0.0);
}

TEST(WhitecapsHard, RipplesAndNoWindLeaveTheFieldDark) {
  const WaveField waves = seaOf(0.05, 1.0);
  const WhitecapRule rule(waves, 20.0);
  EXPECT_EQ(rule.perHeight, 0.0);
  EXPECT_EQ(WhitecapRule(seaOf(3.0, 9.0), 0.0).mean, 0.0);
  const WhitecapRule hurricane(seaOf(12.0, 14.0), 80.0);
  EXPECT_EQ(hurricane.mean, 1.0);
  EXPECT_GT(hurricane.cover(0.0, {0.0, 0.0}), 0.49);
}

}  // namespace
}  // namespace seaway
