#include "sim_bridge/scene/sea.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sim_bridge/scene/partial_sea.h"
#include "sim_bridge/scene/scene_loader.h"
#include "surface/angles.h"
#include "tests/sim_bridge/test_support.h"

namespace seaway::bridge {
namespace {

using Replacements = std::vector<std::pair<std::string, std::string>>;

Sea seaWith(const Replacements& replacements) {
  const test::TempFolder folder;
  return buildSea(loadScene(test::writeScene(folder, replacements)));
}

TEST(Sea, RealisesTheWaveHeightAskedFor) {
  // 2 % is what `seaway run` promises; the estimate's own scatter is below 0.5 %.
  for (const Replacements& sea :
       {Replacements{}, Replacements{{"1.12", "9"}, {"5.6", "13"}},
        Replacements{{"jonswap", "pierson_moskowitz"}}, Replacements{{"inf", "6"}}}) {
    const Sea built = seaWith(sea);
    EXPECT_NEAR(realisedSignificantWaveHeight(built.surface), built.hm0Asked,
                0.02 * built.hm0Asked);
  }
}

TEST(Sea, APartOfItIsWhatAToleranceLeaves) {
  const test::TempFolder folder;
  for (const char* model : {"group", "perlin"}) {
    const Scene scene = loadScene(
        test::writeScene(folder, {{"seed: 7", std::string("seed: 7\n  model: ") + model}}));
    const WaterSurface whole = buildSea(scene).surface;
    const std::size_t all = whole.waves().octaves().size();
    for (const std::size_t kept : {std::size_t{0}, std::size_t{3}, all, all + 7}) {
      const WaterSurface part = buildPartialSea(scene, kept).surface;
      EXPECT_EQ(part.waves().octaves().size(), std::min(kept, all));
      const SampleOptions options{.tolerance = whole.waves().leftOut(std::min(kept, all))};
      for (const glm::dvec2 place : {glm::dvec2(3.0, 4.0), glm::dvec2(-512.3, 77.7)}) {
        EXPECT_EQ(part.sample(place, 12.0).height, whole.sample(place, 12.0, options).height)
            << model << ' ' << kept;
      }
    }
  }
}

TEST(Sea, RealisedWaveHeightScattersByLessThanHalfAPercent) {
  double sum = 0.0;
  double squares = 0.0;
  constexpr int seeds = 12;
  for (int seed = 0; seed < seeds; ++seed) {
    const double ratio = realisedSignificantWaveHeight(
                             seaWith({{"seed: 7", "seed: " + std::to_string(seed)}}).surface) /
                         1.12;
    sum += ratio;
    squares += ratio * ratio;
  }
  const double mean = sum / seeds;
  EXPECT_LT(std::sqrt(squares / seeds - mean * mean), 0.005);
}

TEST(Sea, CalmIsFlatAndCostsNoOctave) {
  const Sea sea =
      seaWith({{"    jonswap:\n      hm0_m: 1.12\n      tp_s: 5.6\n      from_deg: 196\n",
                "    calm: {}\n"}});
  EXPECT_EQ(sea.surface.waves().octaves().size(), 0u);
  EXPECT_EQ(sea.surface.sample({3.0, 4.0}, 5.0).height, 0.0);
  EXPECT_EQ(realisedSignificantWaveHeight(sea.surface), 0.0);
}

TEST(Sea, WavesSwitchedOffAreFlatWater) {
  const Sea sea = seaWith({{"run:", "effects: {waves: off}\nrun:"}});
  EXPECT_EQ(sea.surface.waves().octaves().size(), 0u);
  EXPECT_EQ(sea.hm0Asked, 0.0);
}

TEST(Sea, OctavesSpreadAboutTheMeanDirection) {
  const double mean = towardFromCompassFrom(196.0);
  const Sea narrow = seaWith({{"from_deg: 196", "from_deg: 196\n      spread_s: .inf"}});
  for (const Octave& octave : narrow.surface.waves().octaves()) {
    EXPECT_NEAR(octave.toward, mean, 1e-12);
  }
  const Sea wide = seaWith({{"from_deg: 196", "from_deg: 196\n      spread_s: 2"}});
  double least = 10.0;
  double most = -10.0;
  for (const Octave& octave : wide.surface.waves().octaves()) {
    least = std::min(least, octave.toward - mean);
    most = std::max(most, octave.toward - mean);
  }
  EXPECT_LT(least, -0.5);
  EXPECT_GT(most, 0.5);
}

TEST(Sea, HasTheCountOfOctavesThatTheSceneStates) {
  EXPECT_EQ(seaWith({}).surface.waves().octaves().size(), 24u);
  for (const char* count : {"1", "2", "7", "40"}) {
    const Sea sea = seaWith({{"tp_s: 5.6", "tp_s: 5.6\n      octaves: " + std::string(count)}});
    // The fit may leave one of few octaves without energy; the field drops it.
    const auto asked = static_cast<std::size_t>(std::stoi(count));
    EXPECT_LE(sea.surface.waves().octaves().size(), asked);
    EXPECT_GE(sea.surface.waves().octaves().size(), asked - asked / 5);
  }
}

TEST(Sea, DirectionsDoNotDependOnTheSeed) {
  const Sea a = seaWith({}), b = seaWith({{"seed: 7", "seed: 8"}});
  for (std::size_t i = 0; i < a.surface.waves().octaves().size(); ++i) {
    EXPECT_EQ(a.surface.waves().octaves()[i].toward, b.surface.waves().octaves()[i].toward);
  }
}

TEST(Sea, CurrentSetsWhereTheCompassSays) {
  const Sea sea = seaWith({{"seed: 7", "seed: 7\n  current: {speed_m_s: 2, toward_deg: 90}"}});
  EXPECT_NEAR(sea.surface.waves().settings().current.x, 2.0, 1e-12);
  EXPECT_NEAR(sea.surface.waves().settings().current.y, 0.0, 1e-12);
}

TEST(Sea, InlineOctavesAreTheField) {
  const Sea sea =
      seaWith({{"    jonswap:\n      hm0_m: 1.12\n      tp_s: 5.6\n      from_deg: 196\n",
                "    octaves:\n      - {standard_deviation_m: 0.3, lattice_m: 20, "
                "toward_deg: 0}\n      - {standard_deviation_m: 0.4, lattice_m: 9, "
                "toward_deg: 10}\n"}});
  EXPECT_EQ(sea.surface.waves().octaves().size(), 2u);
  EXPECT_NEAR(sea.hm0Asked, 2.0, 1e-12);
}

}  // namespace
}  // namespace seaway::bridge
