#include "render/surf.h"

#include <gtest/gtest.h>

#include <cmath>
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

TEST(Surf, WhitensTheShallowsInEveryTechniqueAndNothingFartherOut) {
  const WaterSurface water = beachSea(test::groupSea(0.5, 4.0));
  const Camera camera = aboveTheEdge();
  const double farthest = 20.0 * Surf(water.sharedTerrain(), water.waves()).deepest();
  for (const Way& way : allWays({96, 96})) {
    SCOPED_TRACE(way.name);
    EffectLedger effects;
    const Frame frame = labelled(*way.make(), water, camera, effects);
    // All waves break there: white where the surface is above still water, half of all places,
    // within the scatter of some waves.
    EXPECT_NEAR(foamAt(frame, camera, 9.0), 0.5, 0.25);
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
