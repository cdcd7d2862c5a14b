#include "render/swimming.h"

#include <gtest/gtest.h>

#include "tests/render/seas.h"

namespace seaway::render {
namespace {

View viewOf(const WaterSurface& water, EffectLedger& effects) {
  View view;
  view.water = &water;
  view.time = 3.0;
  view.camera = test::cameraAt({0, 0, 6}, -9.0, 0.0, 50.0);
  view.effects = &effects;
  return view;
}

constexpr CameraMotion ahead{{0.23, 0.1, 0.0}, 0.0}, turning{{0.0, 0.0, 0.0}, 0.01};

TEST(Swimming, IsNothingForACameraAtRestAndForAStillSea) {
  EffectLedger effects;
  const auto technique = makeSoftwareGrid({.grid = {48, 48}});
  const WaterSurface waves = test::groupSea(1.12, 5.6), still = test::stillSea();
  // One grid twice, but placed from different origins: rounding.
  EXPECT_LT(swimming(*technique, viewOf(waves, effects), {}, 2), 1e-9);
  // Flat water is the same by any grid, but for chords of its curvature and single precision.
  EXPECT_LT(swimming(*technique, viewOf(still, effects), ahead, 2), 2e-3);
  EXPECT_LT(swimming(*technique, viewOf(still, effects), turning, 2), 2e-3);
}

TEST(Swimming, GrowsWithTheStepAndFallsWithTheGrid) {
  EffectLedger effects;
  const WaterSurface waves = test::groupSea(1.12, 5.6);
  const View view = viewOf(waves, effects);
  const auto coarse = makeSoftwareGrid({.grid = {32, 32}});
  const auto fine = makeSoftwareGrid({.grid = {128, 256}});
  for (const CameraMotion& motion : {ahead, turning}) {
    const double changed = swimming(*coarse, view, motion, 2);
    EXPECT_GT(changed, 1e-3);
    EXPECT_LT(swimming(*coarse, view, {0.1 * motion.step, 0.1 * motion.turn}, 2), 0.5 * changed);
    EXPECT_LT(swimming(*fine, view, motion, 2), 0.5 * changed);
  }
}

TEST(Swimming, IsSeenByAGridThatStaysWithTheLastCamera) {
  // The grid of another camera, drawn from here, leaves what only this one sees undrawn.
  EffectLedger effects;
  const WaterSurface still = test::stillSea();
  View view = viewOf(still, effects);
  const Camera beside = test::cameraAt({40, 0, 6}, -9.0, 0.0, 50.0);
  const auto technique = makeSoftwareGrid({.grid = {64, 64}});
  const auto waterPixels = [&] {
    const Frame frame = technique->draw(view);
    return std::count(frame.classes.begin(), frame.classes.end(), PixelClass::water);
  };
  const auto own = waterPixels();
  view.gridCamera = &beside;
  const auto others = waterPixels();
  // It stands 40 m ahead: what lies between, most of this picture, is not in its grid.
  EXPECT_LT(others, 0.95 * static_cast<double>(own));
  EXPECT_GT(others, 0.05 * static_cast<double>(own));
}

}  // namespace
}  // namespace seaway::render
