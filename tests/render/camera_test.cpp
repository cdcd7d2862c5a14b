#include "render/camera.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <limits>

#include "surface/angles.h"
#include "surface/input_error.h"
#include "tests/render/seas.h"

namespace seaway::render {
namespace {

constexpr double rounding = 1e-12;  // a few operations on numbers near 1

void expectNear(glm::dvec3 a, glm::dvec3 b, double tolerance = rounding) {
  EXPECT_LE(glm::distance(a, b), tolerance) << a.x << ' ' << a.y << ' ' << a.z;
}

TEST(Camera, LooksAlongXWithLeftAlongYAndUpAlongZ) {
  const Camera camera;
  expectNear(camera.forward(), {1, 0, 0});
  expectNear(camera.left(), {0, 1, 0});
  expectNear(camera.up(), {0, 0, 1});
}

TEST(Camera, AttitudeTurnsToTheHeadingRaisesTheBowAndLowersStarboard) {
  const glm::dquat north = attitude(0.5 * pi, 0.0, 0.0);
  expectNear(north * glm::dvec3(1, 0, 0), {0, 1, 0});
  EXPECT_GT((attitude(0.0, 0.1, 0.0) * glm::dvec3(1, 0, 0)).z, 0.09);
  EXPECT_LT((attitude(0.0, 0.0, 0.1) * glm::dvec3(0, -1, 0)).z, -0.09);  // starboard is −y
}

TEST(Camera, EyeSpaceHasXToTheRightAndLooksAlongMinusZ) {
  Camera camera;
  camera.worldFromCamera = attitude(0.7, -0.2, 0.4);
  const glm::dmat4 eyeFromWorld = camera.eyeFromRelativeWorld();
  expectNear(glm::dvec3(eyeFromWorld * glm::dvec4(camera.forward(), 0.0)), {0, 0, -1});
  expectNear(glm::dvec3(eyeFromWorld * glm::dvec4(camera.left(), 0.0)), {-1, 0, 0});
  expectNear(glm::dvec3(eyeFromWorld * glm::dvec4(camera.up(), 0.0)), {0, 1, 0});
}

TEST(Camera, RaysThroughPixelsAreTheInverseOfProjection) {
  Camera camera;
  camera.worldFromCamera = attitude(2.0, -0.3, 0.2);
  camera.verticalFieldOfView = 1.1;
  for (const glm::ivec2 pixel :
       {glm::ivec2(0, 0), glm::ivec2(640, 360), glm::ivec2(1279, 719), glm::ivec2(17, 700)}) {
    const glm::dvec3 ray = camera.rayThrough(pixel);
    EXPECT_NEAR(glm::length(ray), 1.0, rounding);
    const glm::dvec4 clip = camera.clipFromRelativeWorld() * glm::dvec4(ray * 100.0, 1.0);
    EXPECT_NEAR(0.5 * (clip.x / clip.w + 1.0) * 1280, pixel.x + 0.5, 1e-9);
    EXPECT_NEAR(0.5 * (1.0 - clip.y / clip.w) * 720, pixel.y + 0.5, 1e-9);
  }
}

TEST(Camera, VerticalFieldOfViewSpansTheImageFromTopToBottomEdge) {
  Camera camera;
  camera.verticalFieldOfView = radiansFromDegrees(50.0);
  const glm::dvec3 top = camera.rayThrough({639.5, -0.5});
  EXPECT_NEAR(std::asin(top.z), radiansFromDegrees(25.0), rounding);
}

TEST(Camera, ValuesOutOfRangeAreRefusedWithTheValueNamed) {
  const auto refused = [](auto change) {
    Camera camera;
    change(camera);
    EXPECT_THROW(validate(camera), InputError);
  };
  EXPECT_NO_THROW(validate(Camera{}));
  refused([](Camera& c) { c.size = {0, 720}; });
  refused([](Camera& c) { c.size = {1280, -1}; });
  refused([](Camera& c) { c.verticalFieldOfView = 0.0; });
  refused([](Camera& c) { c.verticalFieldOfView = pi; });
  refused([](Camera& c) { c.verticalFieldOfView = std::numeric_limits<double>::quiet_NaN(); });
  refused([](Camera& c) { c.position.y = std::numeric_limits<double>::infinity(); });
  refused([](Camera& c) { c.worldFromCamera = {0.0, 0.0, 0.0, 0.0}; });
  refused([](Camera& c) { c.nearDistance = 0.0; });
  refused([](Camera& c) { c.farDistance = c.nearDistance; });
  try {
    Camera camera;
    camera.size = {0, 720};
    validate(camera);
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("0x720"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace seaway::render
