#include "sim_bridge/scene/sea_state_schema.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "sim_bridge/scene/parametric_spectrum.h"
#include "sim_bridge/scene/scene_loader.h"
#include "sim_bridge/scene/sea.h"
#include "surface/angles.h"
#include "tests/sim_bridge/test_support.h"

namespace seaway::bridge {
namespace {

using test::TempFolder;

const std::string jonswapState =
    "    jonswap:\n      hm0_m: 1.12\n      tp_s: 5.6\n      from_deg: 196\n";

Scene sceneOf(const TempFolder& folder, const std::string& state,
              const std::string& extra = "seed: 7") {
  return loadScene(
      test::writeScene(folder, {{jonswapState, "    " + state + "\n"}, {"seed: 7", extra}}));
}

std::string faultOf(const std::string& state) {
  const TempFolder folder;
  std::string message = test::inputErrorOf([&] { sceneOf(folder, state); });
  const std::string prefix = folder.path().string() + "/";
  return message.rfind(prefix, 0) == 0 ? message.substr(prefix.size()) : message;
}

TEST(SeaStateSchema, EveryFamilyRealisesItsWaveHeight) {
  struct Case {
    const char* state;
    double hm0;
  };
  for (const Case& sea : {
           Case{"tma: {hm0_m: 1.5, tp_s: 7, from_deg: 10}", 1.5},
           // 2√(α/β) U²/g of the fully developed sea, over the band that is fitted.
           Case{"pierson_moskowitz: {wind_m_s: 12, from_deg: 10}", 0.2092 * 144.0 / 9.80665},
           Case{"pierson_moskowitz: {hm0_m: 2, tp_s: 8, from_deg: 10}", 2.0},
           Case{"ochi_hubble: {hm0_m: 3, from_deg: 10}", 3.0},
           Case{"ochi_hubble: {swell: {hm0_m: 3, tp_s: 14, lambda: 3}, "
                "wind_sea: {hm0_m: 4, tp_s: 7}, from_deg: 10}",
                5.0},
           Case{"torsethaugen: {hm0_m: 4, tp_s: 14, from_deg: 10}", 4.0},
           Case{"swell: {hm0_m: 2, tp_s: 16, from_deg: 300, spread_s: 75}", 2.0},
           // The middle of the class of 2.5 to 4 m.
           Case{"wmo: {state: 5, from_deg: 10}", 3.25},
       }) {
    SCOPED_TRACE(sea.state);
    const TempFolder folder;
    const Scene scene = sceneOf(folder, sea.state);
    const Sea built = buildSea(scene);
    // A family's own band leaves out less than 1 % of the analytic height.
    EXPECT_NEAR(built.hm0Asked, sea.hm0, 0.01 * sea.hm0);
    // As for JONSWAP seas: `seaway run` promises 2 %.
    EXPECT_NEAR(realisedSignificantWaveHeight(built.surface), sea.hm0, 0.02 * sea.hm0);
    // The fit leaves out what has no energy.
    EXPECT_LE(built.surface.waves().octaves().size(), 24u);
  }
}

TEST(SeaStateSchema, TmaGoesByTheSeasOwnDepth) {
  const TempFolder folder;
  const char* state = "tma: {hm0_m: 1, tp_s: 8, from_deg: 10}";
  const Scene deep = sceneOf(folder, state);
  const ParametricState& asked = std::get<ParametricState>(deep.sea.state);
  // In 5 m of water φ takes energy from below the peak: shorter mean period.
  EXPECT_LT(spectrumOf(asked, 5.0).meanPeriodM01(), 0.95 * spectrumOf(asked, 1e4).meanPeriodM01());
}

TEST(SeaStateSchema, MitsuyasusSpreadingIsNarrowestAtThePeak) {
  const TempFolder folder;
  const Scene scene = sceneOf(folder,
                              "jonswap: {hm0_m: 1.12, tp_s: 5.6, from_deg: 196, "
                              "spread: mitsuyasu, spread_wind_m_s: 9}");
  const auto& state = std::get<ParametricState>(scene.sea.state);
  const double infinity = std::numeric_limits<double>::infinity();
  const auto exponentOf = exponentsOf(state, spectrumOf(state, infinity), infinity);
  const auto at = [&](double ratio) {
    return exponentOf(makeGroupOctave(0.1, ratio / 5.6, 0.1 / 5.6, 0.0, 0.3));
  };
  // s_p = 11.5 (2π f_p U/g)^−2.5 = 11.5 · 1.0297^−2.5; the peak is read from bins.
  EXPECT_NEAR(at(1.0), 10.69, 0.3);
  EXPECT_NEAR(at(2.0) / at(1.0), std::pow(2.0, -2.5), 0.02);
  EXPECT_EQ(at(0.5), 0.5);  // 1/32 of the peak's would be below what is allowed

  // Near the peak octaves stand as with that exponent for all, short ones much farther out.
  const auto angles = [](const Sea& sea) {
    const double mean = towardFromCompassFrom(196.0);
    std::array<double, 2> sum{}, weight{};  // near the peak, in the tail
    for (const Octave& octave : sea.surface.waves().octaves()) {
      const double ratio = bandOf(octave).frequency * 5.6;
      const int where = ratio > 0.85 && ratio < 1.15 ? 0 : ratio > 1.8 ? 1 : -1;
      if (where < 0) continue;
      const double energy = octave.standardDeviation * octave.standardDeviation;
      sum[where] += energy * std::abs(octave.toward - mean);
      weight[where] += energy;
    }
    return std::array{sum[0] / weight[0], sum[1] / weight[1]};
  };
  const auto byWind = angles(buildSea(scene));
  const TempFolder other;
  const auto even = angles(buildSea(
      sceneOf(other, "jonswap: {hm0_m: 1.12, tp_s: 5.6, from_deg: 196, spread_s: 10.69}")));
  // Pairs alternate by 15 % about their mean angle, and spread a little below the peak already.
  EXPECT_NEAR(byWind[0], even[0], 0.25 * even[0]);
  EXPECT_GT(byWind[1], 1.5 * even[1]);
}

TEST(SeaStateSchema, FaultsSayWhatIsAllowed) {
  EXPECT_EQ(faultOf("pierson_moskowitz: {hm0_m: 2, from_deg: 1}"),
            "scene.yaml:6: key 'sea.state.pierson_moskowitz': needs hm0_m and tp_s, or wind_m_s "
            "alone");
  EXPECT_EQ(faultOf("pierson_moskowitz: {wind_m_s: 9, hm0_m: 2, tp_s: 9, from_deg: 1}"),
            "scene.yaml:6: key 'sea.state.pierson_moskowitz': needs hm0_m and tp_s, or wind_m_s "
            "alone");
  EXPECT_EQ(faultOf("wmo: {state: 0, from_deg: 1}"),
            "scene.yaml:6: key 'sea.state.wmo.state': 0 is not allowed; must be a whole number in "
            "[1, 9]");
  EXPECT_EQ(faultOf("swell: {hm0_m: 2, tp_s: 16, width_hz: 0.04, from_deg: 1}"),
            "scene.yaml:6: key 'sea.state.swell.width_hz': 0.04 is not allowed; must be in "
            "(0, 0.03125] Hz");
  EXPECT_EQ(faultOf("ochi_hubble: {swell: {hm0_m: 1, tp_s: 9}, from_deg: 1}"),
            "scene.yaml:6: key 'sea.state.ochi_hubble': needs hm0_m alone, or swell and wind_sea");
  EXPECT_EQ(faultOf("ochi_hubble: {hm0_m: 21, from_deg: 1}"),
            "scene.yaml:6: key 'sea.state.ochi_hubble.hm0_m': 21 is not allowed; must be in "
            "[0, 20] m");
  EXPECT_EQ(faultOf("tma: {hm0_m: 2, tp_s: 8, gamma: 30, from_deg: 1}"),
            "scene.yaml:6: key 'sea.state.tma.gamma': 30 is not allowed; must be in [1, 20]");
  EXPECT_EQ(faultOf("tma: {hm0_m: 2, tp_s: 8, from_deg: 1, spread: mitsuyasu}"),
            "scene.yaml:6: key 'sea.state.tma': lacks 'spread_wind_m_s', which `spread: "
            "mitsuyasu` goes by");
  EXPECT_EQ(faultOf("wmo: {state: 5, from_deg: 1, spread_wind_m_s: 8}"),
            "scene.yaml:6: key 'sea.state.wmo.spread_wind_m_s': is for `spread: mitsuyasu` only");
  EXPECT_NE(faultOf("torsethaugen: {hm0_m: 2, tp_s: 8, from_deg: 1, spread: mitsuyasu}")
                .find("unknown key"),
            std::string::npos);
}

}  // namespace
}  // namespace seaway::bridge
