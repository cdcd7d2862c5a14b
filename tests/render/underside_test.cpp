#include <gtest/gtest.h>

#include "render/compare_frames.h"
#include "tests/render/seas.h"

namespace seaway::render {
namespace {

// From below there is no horizon: level rays meet the underside farther and farther off as the sea
// curves down. All techniques draw it as far as a camera as high above would see.
TEST(UndersideHard, EndsWhereTheReferenceEndsIt) {
  const ProjectedGridOptions options{.grid = {128, 512}};
  const auto grid = makeSoftwareGrid(options), reference = makeReference(options);
  const struct {
    double depth, pitch, roll, fov;
  } views[] = {{28.0, -1.0, -21.0, 8.0}, {45.0, 3.0, -2.0, 11.0}, {2.0, 1.0, 0.0, 6.0},
               {46.0, 25.0, 12.0, 91.0}, {14.0, 0.0, 90.0, 5.0},  {300.0, -3.0, 5.0, 20.0}};
  for (const WaterSurface& water : {test::stillSea(), test::moderateSea()}) {
    for (const auto& v : views) {
      const Camera camera = test::cameraAt({5.0, 6.0, -v.depth}, v.pitch, v.roll, v.fov, {96, 60});
      const Frame drawn = test::drawnBy(*grid, water, camera, 3.0);
      const Frame truth = test::drawnBy(*reference, water, camera, 3.0);
      const FrameComparison c = compareFrames(camera, drawn, truth);
      EXPECT_GT(c.compared, 0u) << v.depth;
      EXPECT_EQ(c.missing, 0u) << v.depth << " m deep";
      // The grid's last row and sides are straight where the end is round: a hair of its distance.
      EXPECT_LE(c.extra, 6u) << v.depth << " m deep";
    }
  }
}

}  // namespace
}  // namespace seaway::render
