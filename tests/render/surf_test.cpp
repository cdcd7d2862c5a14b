#include "render/surf.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

#include "render/grid_cover.h"
#include "tests/render/terrain/grounds.h"

// Foam of waves that break on a shore.
namespace seaway::render {
namespace {

using test::allWays;
using test::looking;
using test::picture;
using test::Picture;
using test::Way;

/// A beach that rises eastwards by 1 in 20, its water's edge at x = 0.
WaterSurface beachSea(WaterSurface water) {
  water.setTerrain(test::ground({81, 41}, 5.0, [](glm::dvec2 p) { return 0.05 * p.x; }));
  return water;
}

/// From 150 m above the edge, straight down: east is up in the picture.
Camera aboveTheEdge() { return looking({0.0, 0.0, 150.0}, 0.0, -90.0, 60.0, {64, 96}); }

/// Mean foam of the water at a distance seawards of the edge, m, [0, 1].
double foamAt(const Frame& frame, const Camera& camera, double seawards) {
  const double perPixel = 2.0 * std::tan(0.5 * camera.verticalFieldOfView) / camera.size.y;
  const int row = static_cast<int>(
      std::lround(0.5 * (camera.size.y - 1) + seawards / (camera.position.z * perPixel)));
  double sum = 0.0;
  for (int x = 0; x < camera.size.x; ++x) {
    sum += frame.foam[static_cast<std::size_t>(row) * camera.size.x + x] / 255.0;
  }
  return sum / camera.size.x;
}

Frame labelled(RenderTechnique& technique, const WaterSurface& water, const Camera& camera,
               EffectLedger& effects) {
  View view;
  view.water = &water;
  view.time = 3.0;
  view.camera = camera;
  view.light.windSpeed = 0.0;  // no whitecaps
  view.effects = &effects;
  view.wantsLabels = true;
  return technique.draw(view);
}

TEST(Surf, BreaksAsThorntonAndGuzasShareOfWavesDoes) {
  const WaterSurface water = beachSea(test::groupSea(0.5, 4.0));
  const Surf surf(water.sharedTerrain(), water.waves());
  const double all = 0.5 / std::sqrt(2.0) / 0.42;  // m: the depth at which (H_rms/γh)⁴ is 1
  EXPECT_EQ(surf.breaking(-3.0), 1.0);
  EXPECT_EQ(surf.breaking(0.99 * all), 1.0);
  EXPECT_NEAR(surf.breaking(2.0 * all), 1.0 / 16.0, 1e-12);
  EXPECT_NEAR(surf.breaking(surf.deepest()), 1.0 / 255.0, 1e-9);
}

constexpr double period = 1.0 / 0.3;  // s

/// Regular waves of 0.4 m that come in over that beach and break where it is less than 0.95 m deep.
WaterSurface regularBeach() {
  return beachSea(WaterSurface(WaveField({makeRegularWave(0.2, 1.0 / period, 0.0)})));
}

struct Passage {
  std::vector<double> foam;
  int front = 0;  ///< when foam grows fastest
  int crest = 0;
  double mean = 0.0;
};

/// Foam at a distance seawards of the edge during one period.
Passage passageAt(double seawards, double keptWavelength = 0.0) {
  constexpr int steps = 400;
  const WaterSurface water = regularBeach();
  const Surf surf(water.sharedTerrain(), water.waves());
  const double x = -seawards, y = 0.0;
  Passage passage;
  double highest = -1.0;
  for (int i = 0; i < steps; ++i) {
    const SurfaceAtTime now = water.at(period * i / steps);
    float foam = 0.0f;
    surf.addTo(now, {&x, 1}, {&y, 1}, keptWavelength, {&foam, 1});
    passage.foam.push_back(foam);
    passage.mean += foam / steps;
    const double height = now.waves().sample({x, y}).height;
    if (height > highest) highest = height, passage.crest = i;
  }
  const auto growth = [&](int i) {
    return passage.foam[static_cast<std::size_t>((i + 8) % steps)] -
           passage.foam[static_cast<std::size_t>(i)];
  };
  for (int i = 1; i < steps; ++i) {
    if (growth(i) > growth(passage.front)) passage.front = i;
  }
  return passage;
}

TEST(Surf, ComesAsBoresWhiteOnTheFrontThatLeaveFoamWhichDecays) {
  const Passage passage = passageAt(12.0);
  const int steps = static_cast<int>(passage.foam.size());
  const auto after = [&](int i) {
    return passage.foam[static_cast<std::size_t>((passage.front + i) % steps)];
  };
  // Its roller begins an eighth of a period or so before the crest passes, as sharp as a 60th.
  const double ahead = (passage.crest - passage.front + steps) % steps;
  EXPECT_NEAR(ahead / steps, 0.14, 0.04);
  EXPECT_GT(after(8) - after(0), 0.5);
  for (int i = 8; i + 1 < steps - 8; ++i) EXPECT_LE(after(i + 1), after(i) + 1e-4) << i;
  // White for less than a tenth of the time; little is left when the next one comes.
  EXPECT_LT(after(steps / 10), 0.6);
  EXPECT_LT(after(steps - 8), 0.25);
}

TEST(Surf, ThinsShorewards) {
  const double surf = passageAt(12.0).mean, shallows = passageAt(2.0).mean;
  const double swash = passageAt(-3.0).mean, dry = passageAt(-8.0).mean;
  EXPECT_LT(shallows, 0.85 * surf);
  EXPECT_LT(swash, 0.6 * shallows);
  EXPECT_GT(swash, 0.0);
  EXPECT_EQ(dry, 0.0);  // 0.4 m above still water, where waves of 0.2 m do not reach
}

/// Mean foam over a stretch along the shore and an hour of an irregular sea.
double meanAt(double seawards, double keptWavelength) {
  static const WaterSurface water = beachSea(test::groupSea(0.5, 4.0));
  const Surf surf(water.sharedTerrain(), water.waves());
  std::array<double, 16> x, y;
  x.fill(-seawards);
  for (std::size_t i = 0; i < y.size(); ++i) y[i] = 12.0 * static_cast<double>(i) - 90.0;
  double sum = 0.0;
  constexpr int times = 500;
  for (int i = 0; i < times; ++i) {
    std::array<float, 16> foam{};
    surf.addTo(water.at(7.3 * i), x, y, keptWavelength, foam);
    for (const float each : foam) sum += each;
  }
  return sum / (16.0 * times);
}

TEST(Surf, HasTheSameMeanWhereNoGridShowsItsWaves) {
  for (const double seawards : {20.0, 12.0, 6.0, 2.0, 0.0, -3.0, -8.0}) {
    const double shown = meanAt(seawards, 0.0), hidden = meanAt(seawards, 1000.0);
    std::printf("%4.0f m seawards: %.3f shown, %.3f hidden\n", seawards, shown, hidden);
    // Phases of an irregular sea are not those of a row of regular waves.
    EXPECT_NEAR(hidden, shown, 0.02) << seawards;
  }
}

TEST(Surf, WhitensTheShallowsInEveryTechniqueAndNothingFartherOut) {
  const WaterSurface water = beachSea(test::groupSea(0.5, 4.0));
  const Camera camera = aboveTheEdge();
  const double farthest = 20.0 * Surf(water.sharedTerrain(), water.waves()).deepest();
  for (const Way& way : allWays({96, 96})) {
    SCOPED_TRACE(way.name);
    EffectLedger effects;
    const Frame frame = labelled(*way.make(), water, camera, effects);
    // All waves break there: about a quarter is foam, within the scatter of some waves.
    const double whiteness = foamAt(frame, camera, 9.0);
    EXPECT_GT(whiteness, 0.1);
    EXPECT_LT(whiteness, 0.45);
    EXPECT_LT(foamAt(frame, camera, farthest + 4.0), 0.01);
    const EffectReport foam = effects.report()[static_cast<std::size_t>(Effect::foam)];
    EXPECT_EQ(foam.state, EffectState::on);
    EXPECT_EQ(foam.reason, "waves break on a shore");
  }
}

TEST(Surf, IsNotThereUnlessCalledFor) {
  const auto technique = makeSoftwareGrid({.grid = {48, 48}});
  const auto stateOf = [&](const WaterSurface& water, const Camera& camera, bool isOff) {
    EffectSettings settings{};
    if (isOff) settings[static_cast<std::size_t>(Effect::foam)] = EffectSetting::off;
    EffectLedger effects(settings);
    const Frame frame = labelled(*technique, water, camera, effects);
    for (const std::uint8_t foam : frame.foam) EXPECT_EQ(foam, 0);
    return effects.report()[static_cast<std::size_t>(Effect::foam)].state;
  };
  const WaterSurface beach = beachSea(test::groupSea(0.5, 4.0));
  EXPECT_EQ(stateOf(test::groupSea(0.5, 4.0), aboveTheEdge(), false), EffectState::idle);
  EXPECT_EQ(stateOf(beachSea(test::stillSea()), aboveTheEdge(), false), EffectState::idle);
  EXPECT_EQ(stateOf(beach, aboveTheEdge(), true), EffectState::off);
  const Camera away = looking({-2000.0, 0.0, 5.0}, 180.0, -3.0);
  EXPECT_EQ(stateOf(beach, away, false), EffectState::idle);
}

}  // namespace
}  // namespace seaway::render
