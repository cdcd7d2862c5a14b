#include "surface/field/blocked_octaves.h"

#include <gtest/gtest.h>

#include <cmath>

#include "surface/constants.h"
#include "surface/dispersion.h"

namespace seaway {
namespace {

// Deep-water waves of 3 and 6 s, towards the east: groups at gT/4π, 2.34 and 4.68 m/s.
std::vector<Octave> twoWaves() {
  return {makeGroupOctave(0.1, 1.0 / 3.0, 0.03, 0.0, 0.35), makeRegularWave(0.2, 1.0 / 6.0, 0.0)};
}

TEST(BlockedOctaves, ACurrentStopsThoseWhoseGroupsItOutruns) {
  const double slow = standardGravity * 3.0 / (4.0 * pi);
  EXPECT_TRUE(blockedOctaves(twoWaves(), deepWater, {-0.99 * slow, 0.0}).empty());
  const auto stopped = blockedOctaves(twoWaves(), deepWater, {-1.01 * slow, 0.0});
  ASSERT_EQ(stopped.size(), 1u);
  EXPECT_NEAR(stopped[0].groupSpeed, slow, 1e-12);
  EXPECT_NEAR(stopped[0].wavelength, standardGravity * 9.0 / (2.0 * pi), 1e-10);
  EXPECT_NEAR(stopped[0].currentAgainst, 1.01 * slow, 1e-12);
  const auto both = blockedOctaves(twoWaves(), deepWater, {-2.01 * slow, 0.0});
  ASSERT_EQ(both.size(), 2u);
  EXPECT_GT(both[0].wavelength, both[1].wavelength);
}

TEST(BlockedOctaves, OnlyThePartAgainstTheWavesCounts) {
  EXPECT_TRUE(blockedOctaves(twoWaves(), deepWater, {20.0, 0.0}).empty());
  EXPECT_TRUE(blockedOctaves(twoWaves(), deepWater, {0.0, 20.0}).empty());
  EXPECT_EQ(blockedOctaves(twoWaves(), deepWater, {-3.0, 20.0}).size(), 1u);
}

TEST(BlockedOctaves, ShallowWaterSlowsGroupsDownToTheLongWaveSpeed) {
  // At 0.5 m no group passes √(gd) = 2.2 m/s, which deep water lets both waves do.
  const std::vector<Octave> shallow{makeRegularWave(0.01, 1.0 / 6.0, 0.0, 0.0, 0.5)};
  const double fastest = std::sqrt(standardGravity * 0.5);
  EXPECT_EQ(blockedOctaves(shallow, 0.5, {-fastest, 0.0}).size(), 1u);
  EXPECT_TRUE(blockedOctaves(shallow, 0.5, {-0.9 * fastest, 0.0}).empty());
}

TEST(BlockedOctaves, WavesWithoutEnergyOrGroupsAreNotReported) {
  const std::vector<Octave> octaves{makeRegularWave(0.0, 0.3, 0.0),
                                    makePerlinOctave(0.3, 5.0, 0.0)};
  EXPECT_TRUE(blockedOctaves(octaves, deepWater, {-20.0, 0.0}).empty());
  EXPECT_TRUE(blockedOctaves({}, deepWater, {-20.0, 0.0}).empty());
}

}  // namespace
}  // namespace seaway
