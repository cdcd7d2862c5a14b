#include "render/projector.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "render/sea_grid.h"
#include "render/visible_volume.h"
#include "surface/curvature.h"
#include "surface/surface_ray.h"
#include "tests/render/coverage.h"
#include "tests/render/seas.h"

namespace seaway::render {
namespace {

using test::cameraAt;

TEST(VisibleVolume, IsEmptyWhereOnlySkyIsInView) {
  EXPECT_FALSE(visibleVolume(cameraAt({0, 0, 5}, 45.0), 1.0));
  EXPECT_FALSE(visibleVolume(cameraAt({0, 0, 5}, 90.0), 1.0));
  EXPECT_TRUE(visibleVolume(cameraAt({0, 0, 5}, 20.0), 1.0));
}

TEST(VisibleVolume, ReachesNoFartherThanCrestsShow) {
  const auto volume = visibleVolume(cameraAt({0, 0, 3}, 0.0, 0.0, 10.0), 1.5);
  ASSERT_TRUE(volume);
  // 6.2 km to the horizon and 4.4 km beyond; the corners of a 17° wide view lie 1 % farther.
  EXPECT_GT(volume->reach, 10.5e3);
  EXPECT_LT(volume->reach, 11.1e3);
}

TEST(VisibleVolume, LookingDownIsNotWidenedByTheDropAtTheHorizon) {
  const auto volume = visibleVolume(cameraAt({0, 0, 300}, -90.0, 0.0, 60.0, {90, 90}), 1.0);
  ASSERT_TRUE(volume);
  const double expected = 301.0 * std::tan(radiansFromDegrees(30.0)) * std::sqrt(2.0);
  EXPECT_NEAR(volume->reach, expected, 0.01 * expected);
}

TEST(Projector, StaysAboveAllWavesAndIsMirroredAboveFromBelow) {
  const auto low = Projector::aimedAt(cameraAt({0, 0, 2}, 0.0), 5.0, {.elevation = 1.5});
  ASSERT_TRUE(low);
  EXPECT_NEAR(low->position().z, 6.5, 1e-12);
  const auto below = Projector::aimedAt(cameraAt({0, 0, -40}, 30.0), 5.0);
  ASSERT_TRUE(below);
  EXPECT_NEAR(below->position().z, 40.0, 1e-12);
}

TEST(Projector, AimsAtThePlaneWhereverTheCameraLooks) {
  for (double pitch = -90.0; pitch <= 90.0; pitch += 7.5) {
    for (const double roll : {0.0, 45.0, 90.0, 180.0}) {
      for (const double z : {-20.0, 0.0, 1.0, 20.0, 1000.0}) {
        const auto projector = Projector::aimedAt(cameraAt({0, 0, z}, pitch, roll), 3.0);
        if (!projector) continue;
        EXPECT_GT(projector->depression(), 0.0);
        EXPECT_LE(projector->depression(), 0.5 * pi + 1e-12);
      }
    }
  }
}

TEST(Projector, CornersInterpolatedAndDividedLastAreTheRaysIntersections) {
  const auto projector = Projector::aimedAt(cameraAt({0, 0, 8}, -20.0), 1.0);
  ASSERT_TRUE(projector);
  // Straight rows: three points of a row are collinear, and so are three of a column.
  for (const double v : {0.1, 0.5, 0.9}) {
    const glm::dvec2 a = projector->basePoint(0.0, v), b = projector->basePoint(0.37, v),
                     c = projector->basePoint(1.0, v);
    const double area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    EXPECT_NEAR(area / glm::dot(c - a, c - a), 0.0, 1e-12);
    // Along a row the homogeneous coordinate is constant, so the spacing is even.
    EXPECT_NEAR(glm::distance(a, b) / glm::distance(a, c), 0.37, 1e-9);
  }
}

TEST(Projector, RowsGrowFromTheNearestToTheFarthest) {
  for (const double share : {0.0, 0.5, 1.0}) {
    const auto projector = Projector::aimedAt(cameraAt({0, 0, 3}, -4.0), 1.5,
                                              {.elevation = 1.0, .logarithmicRows = share});
    const std::vector<double> rows = projector->rows(129);
    EXPECT_EQ(rows.front(), 0.0);
    EXPECT_EQ(rows.back(), 1.0);
    for (std::size_t i = 1; i < rows.size(); ++i) EXPECT_GT(rows[i], rows[i - 1]) << i;
    if (share == 0.0) {
      EXPECT_NEAR(rows[64], 0.5, 1e-12);
    }
  }
}

/// Cameras of many kinds, above and below still water.
std::vector<Camera> manyCameras() {
  std::vector<Camera> cameras;
  for (const double z : {-8.0, 0.02, 0.5, 3.0, 30.0, 2000.0}) {
    for (const double pitch : {-90.0, -60.0, -25.0, 0.0, 12.0, 40.0, 90.0}) {
      for (const double roll : {0.0, 45.0, 90.0, 170.0}) {
        for (const double fov : {2.0, 60.0, 140.0}) {
          cameras.push_back(cameraAt({3.0, 7.0, z}, pitch, roll, fov, {32, 18}));
        }
      }
    }
  }
  return cameras;
}

/// Of a grid with few rows, whose straight sides cut corners the most.
std::optional<test::Coverage> coverageOf(const std::optional<Projector>& projector) {
  if (!projector) return std::nullopt;
  return test::Coverage(*projector, 32);
}

TEST(Projector, GridCoversEveryPixelThatShowsStillWater) {
  const WaterSurface still = test::stillSea();
  const SurfaceAtTime now = still.at(0.0);
  std::size_t pixels = 0;
  for (const Camera& camera : manyCameras()) {
    const auto coverage = coverageOf(Projector::aimedAt(camera, 0.0));
    for (int y = 0; y < camera.size.y; ++y) {
      for (int x = 0; x < camera.size.x; ++x) {
        const glm::dvec3 ray = camera.rayThrough({x, y});
        const auto distance = distanceToWater(now, camera.position, ray);
        if (!distance || *distance * glm::dot(ray, camera.forward()) < camera.nearDistance)
          continue;
        if (glm::length(glm::dvec2(ray) * *distance) > crestReach(std::abs(camera.position.z), 0)) {
          continue;  // from below, beyond the horizon
        }
        ++pixels;
        ASSERT_TRUE(coverage);
        ASSERT_TRUE(coverage->holds(glm::dvec2(ray) * *distance))
            << camera.position.z << " m, pixel " << x << ' ' << y;
      }
    }
  }
  EXPECT_GT(pixels, 50000u);
}

TEST(Projector, GridCoversEveryPixelThatShowsWaves) {
  const WaterSurface storm = test::stormSea();
  const SurfaceAtTime now = storm.at(0.0);
  for (const double z : {-15.0, -2.0, 0.0, 4.0, 13.0}) {
    for (const double pitch : {-60.0, -10.0, 0.0, 25.0}) {
      const Camera camera = cameraAt({40.0, 70.0, z}, pitch, 20.0, 75.0, {32, 18});
      const auto coverage = coverageOf(Projector::aimedAt(camera, storm.heightBound()));
      for (int y = 0; y < camera.size.y; ++y) {
        for (int x = 0; x < camera.size.x; ++x) {
          const glm::dvec3 ray = camera.rayThrough({x, y});
          const auto distance = distanceToWater(now, camera.position, ray);
          const double reach = crestReach(std::abs(z), storm.heightBound());
          if (!distance || *distance > reach) continue;
          if (*distance * glm::dot(ray, camera.forward()) < camera.nearDistance) continue;
          ASSERT_TRUE(coverage);
          ASSERT_TRUE(coverage->holds(glm::dvec2(ray) * *distance)) << z << ' ' << pitch;
        }
      }
    }
  }
}

TEST(Projector, MostVerticesLieInThePictureInOrdinaryViews) {
  const WaterSurface still = test::stillSea();
  SeaGrid grid;
  // Johanson: usually 50–95 %. The views are ahead from a mast, down from a drone, rolled.
  const struct {
    Camera camera;
    double least;
  } views[] = {{cameraAt({0, 0, 10}, -10.0), 0.85},
               {cameraAt({0, 0, 100}, -45.0), 0.85},
               {cameraAt({0, 0, 100}, -90.0), 0.9},
               {cameraAt({0, 0, 10}, -5.0, 30.0), 0.8}};
  for (const auto& [camera, least] : views) {
    const auto projector = Projector::aimedAt(camera, 0.5);
    grid.fill(still.at(0.0), camera, projectedLayout(*projector, still.waves(), {64, 64}));
    EXPECT_GT(static_cast<double>(grid.verticesInFrustum(camera)) / (64 * 64), least)
        << camera.position.z;
  }
}

}  // namespace
}  // namespace seaway::render
