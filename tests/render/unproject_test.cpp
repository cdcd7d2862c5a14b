#include "render/unproject.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "surface/curvature.h"
#include "tests/render/seas.h"

namespace seaway::render {
namespace {

TEST(Unproject, InvertsProjectionOnTheCurvedSea) {
  const Camera camera = test::cameraAt({1e5, -2e5, 30.0}, -10.0, 20.0);
  for (const glm::ivec2 pixel : {glm::ivec2(3, 80), glm::ivec2(120, 60)}) {
    const glm::dvec3 ray = camera.rayThrough(pixel);
    const double distance = 321.0;
    const SeaPoint point = unproject(camera, pixel, distance * glm::dot(ray, camera.forward()));
    const glm::dvec3 wanted = camera.position + ray * distance;
    EXPECT_LE(glm::distance(point.point, glm::dvec2(wanted)), 1e-9);
    EXPECT_NEAR(point.height, wanted.z + seaDrop(glm::length(glm::dvec2(ray * distance))), 1e-9);
  }
}

}  // namespace
}  // namespace seaway::render
