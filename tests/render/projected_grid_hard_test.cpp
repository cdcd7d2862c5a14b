#include <gtest/gtest.h>

#include <cmath>

#include "tests/render/seas.h"

// Cameras and seas that break simpler renderers. Each frame must be whole: no throw (an OpenGL
// error throws), classes and depths that fit together, depths positive or +inf.
namespace seaway::render {
namespace {

using test::cameraAt;

void expectWhole(const Frame& frame, const Camera& camera) {
  const std::size_t pixels = static_cast<std::size_t>(camera.size.x) * camera.size.y;
  ASSERT_EQ(frame.colour.rgb.size(), 3 * pixels);
  ASSERT_EQ(frame.depth.metres.size(), pixels);
  ASSERT_EQ(frame.classes.size(), pixels);
  for (std::size_t i = 0; i < pixels; ++i) {
    const float depth = frame.depth.metres[i];
    ASSERT_FALSE(std::isnan(depth));
    ASSERT_GT(depth, 0.0f);
    ASSERT_EQ(std::isinf(depth), frame.classes[i] == PixelClass::sky);
  }
}

Frame wholeFrame(const WaterSurface& water, const Camera& camera, double time = 1.0) {
  const Frame frame = test::drawn(water, camera, time, {.grid = {64, 64}});
  expectWhole(frame, camera);
  // The same without OpenGL, with the same sea but for pixels on outlines.
  const Frame software = test::drawnInSoftware(water, camera, time, {.grid = {64, 64}});
  expectWhole(software, camera);
  std::size_t others = 0;
  for (std::size_t i = 0; i < frame.classes.size(); ++i) {
    others += frame.classes[i] != software.classes[i];
  }
  EXPECT_LE(others, 2 + frame.classes.size() / 100);
  return frame;
}

long waterPixels(const Frame& frame) {
  return std::count(frame.classes.begin(), frame.classes.end(), PixelClass::water);
}

TEST(ProjectedGridHard, CameraExactlyAtTheSurface) {
  const WaterSurface water = test::moderateSea();
  for (const double pitch : {-90.0, -30.0, 0.0, 30.0, 90.0}) {
    glm::dvec3 position(20.0, 30.0, 0.0);
    position.z = water.sample(glm::dvec2(position), 1.0).height;
    wholeFrame(water, cameraAt(position, pitch));
    wholeFrame(test::stillSea(), cameraAt({1.0, 2.0, 0.0}, pitch));
  }
}

TEST(ProjectedGridHard, CameraUnderACrestOfTheStorm) {
  const WaterSurface storm = test::stormSea();
  glm::dvec2 crest(0.0);
  for (int i = 0; i < 400; ++i) {
    const glm::dvec2 point(3.0 * i, 0.0);
    if (storm.sample(point, 1.0).height > storm.sample(crest, 1.0).height) crest = point;
  }
  const double height = storm.sample(crest, 1.0).height;
  ASSERT_GT(height, 3.0);
  for (const double pitch : {-45.0, 0.0, 45.0, 90.0}) {
    const Frame frame = wholeFrame(storm, cameraAt({crest, height - 1.0}, pitch));
    // From a metre under the crest, looking straight up shows its underside everywhere.
    if (pitch == 90.0) {
      EXPECT_EQ(waterPixels(frame), 160 * 90);
    }
  }
}

TEST(ProjectedGridHard, CameraDeepBelowSeesTheUndersideAbove) {
  const Frame up = wholeFrame(test::moderateSea(), cameraAt({0, 0, -30.0}, 60.0));
  EXPECT_EQ(waterPixels(up), 160 * 90);
  const Frame down = wholeFrame(test::moderateSea(), cameraAt({0, 0, -30.0}, -60.0));
  EXPECT_EQ(waterPixels(down), 0);
}

TEST(ProjectedGridHard, StraightDownAndStraightUpInAnyRoll) {
  for (const double roll : {0.0, 33.0, 90.0, 180.0, -90.0}) {
    const Frame down = wholeFrame(test::moderateSea(), cameraAt({5, 6, 20}, -90.0, roll));
    EXPECT_EQ(waterPixels(down), 160 * 90) << roll;
    const Frame up = wholeFrame(test::moderateSea(), cameraAt({5, 6, 20}, 90.0, roll));
    EXPECT_EQ(waterPixels(up), 0) << roll;
  }
}

TEST(ProjectedGridHard, RolledOnItsSideShowsHalfWater) {
  const Frame frame = wholeFrame(test::stillSea(), cameraAt({0, 0, 3}, 0.0, 90.0));
  // The horizon is upright, 0.056° to the side of the middle: a thousandth of the picture.
  EXPECT_NEAR(waterPixels(frame), 0.5 * 160 * 90, 0.01 * 160 * 90);
}

TEST(ProjectedGridHard, PictureOfOnePixel) {
  for (const double pitch : {-90.0, -20.0, 0.0, 60.0}) {
    Camera camera = cameraAt({0, 0, 3}, pitch, 0.0, 60.0, {1, 1});
    const Frame frame = wholeFrame(test::moderateSea(), camera);
    EXPECT_EQ(frame.classes[0], pitch < 0.0 ? PixelClass::water : PixelClass::sky) << pitch;
  }
}

TEST(ProjectedGridHard, VeryNarrowAndVeryWideFieldsOfView) {
  for (const double fov : {1.0, 170.0, 179.0}) {
    for (const double pitch : {-90.0, -40.0, 0.0, 40.0}) {
      for (const double z : {0.5, 8.0, 500.0}) {
        const Frame frame = wholeFrame(test::moderateSea(), cameraAt({0, 0, z}, pitch, 15.0, fov));
        if (pitch == -90.0 && fov == 1.0) {
          EXPECT_EQ(waterPixels(frame), 160 * 90);
        }
      }
    }
  }
}

TEST(ProjectedGridHard, NoWavesAndThirtyMetreWaves) {
  for (const double z : {-5.0, 0.0, 2.0, 60.0}) {
    wholeFrame(test::windSea(0.0, 25.0), cameraAt({0, 0, z}, -5.0));
    wholeFrame(test::windSea(30.0, 400.0), cameraAt({0, 0, z}, -5.0));
  }
}

TEST(ProjectedGridHard, TenThousandKilometresFromTheAnchorAfterAYear) {
  const WaterSurface water = test::moderateSea();
  const Camera camera = cameraAt({1e7, -1e7, 4.0}, -15.0);
  const Frame frame = wholeFrame(water, camera, 3.15e7);
  EXPECT_GT(waterPixels(frame), 9000);
  // The picture there is as smooth as at the anchor: neighbours' depths along a row agree.
  int rough = 0;
  for (int x = 1; x < camera.size.x; ++x) {
    const float a = frame.depth.metres[80 * camera.size.x + x - 1];
    const float b = frame.depth.metres[80 * camera.size.x + x];
    rough += std::abs(a - b) > 0.2f * a;
  }
  EXPECT_EQ(rough, 0);
}

TEST(ProjectedGridHard, HundredKilometresUp) {
  const Frame frame = wholeFrame(test::moderateSea(), cameraAt({0, 0, 1e5}, -45.0));
  EXPECT_EQ(waterPixels(frame), 160 * 90);
}

TEST(ProjectedGridHard, TimeThatIsNoNumberDrawsAStillSea) {
  const WaterSurface water = test::moderateSea();
  const Camera camera = cameraAt({0, 0, 4.0}, -15.0);
  const Frame frame = wholeFrame(water, camera, std::numeric_limits<double>::quiet_NaN());
  EXPECT_GT(waterPixels(frame), 9000);
}

TEST(ProjectedGridHard, GridOfFourVertices) {
  const Frame frame =
      test::drawn(test::moderateSea(), cameraAt({0, 0, 4.0}, -45.0), 0.0, {.grid = {2, 2}});
  EXPECT_GT(waterPixels(frame), 0);
}

}  // namespace
}  // namespace seaway::render
