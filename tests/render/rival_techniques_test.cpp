#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <memory>
#include <string>

#include "render/compare_frames.h"
#include "render/grid_skip.h"
#include "surface/input_error.h"
#include "tests/render/hard_views.h"

// The radial grid and the post-process: the same sea, found otherwise.
namespace seaway::render {
namespace {

struct Rival {
  std::string name;
  std::function<std::unique_ptr<RenderTechnique>(glm::ivec2 grid)> make;
};

std::vector<Rival> rivals() {
  // All octaves displace: what is left is how the techniques find the surface.
  return {{"radial_grid",
           [](glm::ivec2 grid) { return makeRadialGrid({.grid = grid, .displacement = 1.0}); }},
          {"post_process",
           [](glm::ivec2 grid) { return makePostProcess({.grid = grid, .steps = 64}); }}};
}

TEST(RadialLayout, RingsGrowWithTheFourthPowerFromTenCentimetresToTheHorizon) {
  const WaterSurface sea = test::groupSea(1.0, 6.0);
  const GridLayout layout = radialLayout(sea.waves(), {}, 40000.0, {.size = {65, 102}});
  EXPECT_EQ(layout.rings->radius(0), 0.0);
  EXPECT_EQ(layout.rings->radius(1), 0.1);
  EXPECT_NEAR(layout.rings->radius(51), 0.1 + (40000.0 - 0.1) / 16.0, 1e-9);  // half of the i
  EXPECT_NEAR(layout.rings->radius(101), 40000.0, 1e-7);
  EXPECT_EQ(layout.place(7, 0), layout.place(7, 64));
  for (int row = 1; row + 1 < 102; ++row) {
    EXPECT_LE(layout.rows[row].plan.spacing, layout.rows[row + 1].plan.spacing * (1 + 1e-12) + 0.1);
  }
}

// Whatever the picture shows lies in quads that are kept: what is skipped never shows.
TEST(RadialLayout, SkipsMostOfWhatIsOutOfViewAndNothingThatShows) {
  const WaterSurface sea = test::groupSea(3.0, 8.0);
  const GridLayout layout = radialLayout(sea.waves(), {}, 12000.0, {.size = {257, 128}});
  const Camera camera = test::cameraAt({0, 0, 8.0}, -5.0, 7.0, 40.0, {160, 90});
  const auto seen = batchesInView(layout, camera, 2.5, 16);
  const auto kept = std::count(seen.begin(), seen.end(), 1);
  // 66 degrees of azimuth of 360, and batches of 22 degrees that reach out on both sides.
  EXPECT_LT(kept, static_cast<long>(seen.size()) * 2 / 5);
  const Frame frame =
      test::drawnBy(*makeRadialGrid({.grid = {256, 128}, .displacement = 1.0}), sea, camera, 1.0);
  const Frame rays = test::drawnBy(*makeReference({.grid = {256, 128}}), sea, camera, 1.0);
  std::size_t holes = 0;
  for (std::size_t i = 0; i + 160 < rays.classes.size(); ++i) {
    const bool inside = rays.classes[i] == PixelClass::water &&
                        rays.classes[i - std::min<std::size_t>(i, 160)] == PixelClass::water;
    holes += inside && frame.classes[i] != PixelClass::water;
  }
  EXPECT_EQ(holes, 0u);
}

TEST(RivalTechniques, ComeCloserToTheRaysAsTheirTablesGrow) {
  const WaterSurface sea = test::groupSea(1.2, 6.0);
  const Camera camera = test::cameraAt({3, 4, 6.0}, -12.0, 5.0, 60.0, {240, 160});
  const Frame rays = test::drawnBy(*makeReference({.grid = {2048, 2048}}), sea, camera, 2.0);
  for (const Rival& rival : rivals()) {
    double before = 1e9;
    for (const int side : {64, 256, 1024}) {
      const Frame frame = test::drawnBy(*rival.make({side, side}), sea, camera, 2.0);
      const FrameComparison c = compareFrames(camera, frame, rays);
      std::printf("%s %d: rms %.4f px, depth %.5f m\n", rival.name.c_str(), side, c.positionRms,
                  c.depthMedian);
      EXPECT_LT(c.positionRms, 0.6 * before) << rival.name << ' ' << side;
      before = c.positionRms;
    }
    EXPECT_LT(before, 0.05) << rival.name;  // a mesh of 1024 rings; rays in its map are nearer
  }
}

TEST(RivalTechniques, DisplacementByAllOctavesIsNearerThanByTheLargest) {
  const WaterSurface sea = test::groupSea(1.2, 6.0);
  const Camera camera = test::cameraAt({3, 4, 6.0}, -12.0, 5.0, 60.0, {240, 160});
  const Frame rays = test::drawnBy(*makeReference({.grid = {2048, 2048}}), sea, camera, 2.0);
  const auto error = [&](double share) {
    const auto grid = makeRadialGrid({.grid = {512, 512}, .displacement = share});
    return compareFrames(camera, test::drawnBy(*grid, sea, camera, 2.0), rays).depthMedian;
  };
  const double all = error(1.0), most = error(0.99), half = error(0.5);
  EXPECT_LT(all, most);
  EXPECT_LT(most, half);
}

TEST(RivalTechniques, PicturesDoNotDependOnTheNumberOfThreads) {
  const WaterSurface sea = test::groupSea(2.0, 7.0);
  const Camera camera = test::cameraAt({3, 4, 5.0}, -9.0, 5.0, 60.0, {203, 131});
  for (const Rival& rival : rivals()) {
    Frame frames[2];
    for (const std::size_t threads : {1, 5}) {
      const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
      frames[threads > 1] = test::drawnBy(*rival.make({96, 120}), sea, camera, 2.0);
    }
    EXPECT_EQ(frames[0].colour.rgb, frames[1].colour.rgb) << rival.name;
    EXPECT_EQ(frames[0].depth.metres, frames[1].depth.metres) << rival.name;
  }
}

TEST(RivalTechniques, RefuseTablesThatAreNone) {
  EXPECT_THROW(makeRadialGrid({.grid = {2, 64}}), InputError);
  EXPECT_THROW(makeRadialGrid({.innermost = 0.0}), InputError);
  EXPECT_THROW(makeRadialGrid({.displacement = 0.0}), InputError);
  EXPECT_THROW(makePostProcess({.grid = {64, 2}}), InputError);
  EXPECT_THROW(makePostProcess({.steps = 1}), InputError);
}

class RivalViewsHard : public ::testing::TestWithParam<int> {};

// The rivals are not held to half a pixel: they are here to show why the projected grid is.
TEST_P(RivalViewsHard, AreDrawnWholeAndAsNumbers) {
  const test::HardView view = test::hardViews()[static_cast<std::size_t>(GetParam())];
  const Frame truth =
      test::drawnBy(*makeReference({.grid = {128, 256}}), view.water, view.camera, view.time);
  for (const Rival& rival : rivals()) {
    SCOPED_TRACE(view.name + ", " + rival.name);
    const Frame frame = test::drawnBy(*rival.make({512, 256}), view.water, view.camera, view.time);
    test::expectSane(frame, view.camera.size);
    const FrameComparison c = compareFrames(view.camera, frame, truth);
    std::printf("%s, %s: %zu px, rms %.3f, missing %zu, extra %zu, far %zu\n", view.name.c_str(),
                rival.name.c_str(), c.compared, c.positionRms, c.missing, c.extra, c.misplaced);
    // Crests thinner than a ring or a step: a quarter of a row of the picture.
    EXPECT_LE(c.missing + c.extra, 12u);
  }
}

INSTANTIATE_TEST_SUITE_P(Each, RivalViewsHard, ::testing::Range(0, 17));

}  // namespace
}  // namespace seaway::render
