#include "render/row_fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "render/ordinary_views.h"
#include "render/sea_grid.h"
#include "surface/curvature.h"
#include "tests/render/coverage.h"
#include "tests/render/random_views.h"

namespace seaway::render {
namespace {

using test::cameraAt;

/// A place of the curved sea, `height` m high, that a pixel of the camera may show.
struct MaybeSeen {
  glm::dvec2 place;
  bool inView;
};

MaybeSeen crossing(const Camera& camera, glm::dvec2 pixel, double height, double reach, bool far) {
  const glm::dvec3 ray = camera.rayThrough(pixel);
  const double bend = glm::dot(glm::dvec2(ray), glm::dvec2(ray)) / (2.0 * earthMeanRadius);
  const double above = camera.position.z - height;
  const double under = ray.z * ray.z - 4.0 * bend * above;
  if (under < 0.0) return {{}, false};
  const double q = -0.5 * (ray.z + std::copysign(std::sqrt(under), ray.z));
  const double distance = far ? q / bend : above / q;
  const glm::dvec2 place = glm::dvec2(ray) * distance;
  const bool inView = distance * glm::dot(ray, camera.forward()) >= camera.nearDistance &&
                      std::isfinite(distance) && glm::length(place) <= reach;
  return {place, inView};
}

/// Places all over a camera's V_visible, its edges and corners included.
template <typename Use>
void forPlacesInView(const Camera& camera, double bound, Use use) {
  const double reach = crestReach(std::abs(camera.position.z), bound);
  constexpr int lines = 12;
  for (int y = 0; y <= lines; ++y) {
    for (int x = 0; x <= lines; ++x) {
      const glm::dvec2 pixel = glm::dvec2(x, y) / double(lines) * glm::dvec2(camera.size) - 0.5;
      for (const double part : {-1.0, -0.6, 0.0, 0.3, 1.0}) {
        for (const bool far : {false, true}) {
          const MaybeSeen seen = crossing(camera, pixel, part * bound, reach, far);
          if (seen.inView) use(seen.place);
        }
      }
    }
  }
}

/// Counts places checked.
std::size_t expectNothingMissed(const Camera& camera, double bound, std::span<const int> sizes) {
  const auto projector = Projector::aimedAt(camera, bound);
  std::size_t places = 0;
  if (!projector) {
    forPlacesInView(camera, bound, [&](glm::dvec2) { ++places; });
    EXPECT_EQ(places, 0u) << "no grid";
    return 0;
  }
  for (const int rows : sizes) {
    const test::Coverage coverage(*projector, rows);
    EXPECT_TRUE(coverage.isInOrder()) << rows << " rows";
    std::size_t missed = 0;
    forPlacesInView(camera, bound, [&](glm::dvec2 place) {
      ++places;
      missed += !coverage.holds(place);
    });
    EXPECT_EQ(missed, 0u) << rows << " rows";
  }
  return places;
}

TEST(RowFit, MostVerticesLieInThePictureOverOrdinaryViews) {
  // Johanson: usually 50–95 %, by a rectangle.
  std::vector<double> shares;
  SeaGrid grid;
  for (unsigned i = 0; i < 200; ++i) {
    const auto [camera, height] = ordinaryView(i);
    const WaterSurface water = test::windSea(height, 30.0 + 12.0 * height);
    const auto projector = Projector::aimedAt(camera, water.heightBound());
    ASSERT_TRUE(projector);
    grid.fill(water.at(1.0), camera, projectedLayout(*projector, water.waves(), {32, 64}));
    shares.push_back(static_cast<double>(grid.verticesInFrustum(camera)) / (32 * 64));
  }
  std::nth_element(shares.begin(), shares.begin() + 100, shares.end());
  EXPECT_GE(shares[100], 0.85);  // 1000 views of a finer grid: 0.9
}

TEST(RowFit, RowsOfALevelCameraAreAsWideAsItsView) {
  const Camera camera = cameraAt({0, 0, 5}, 0.0, 0.0, 60.0);
  const auto projector = Projector::aimedAt(camera, 1.0);
  ASSERT_TRUE(projector);
  const double tanX = std::tan(radiansFromDegrees(30.0)) * camera.aspectRatio();
  for (const Projector::Line& line : projector->lines(200)) {
    const double width = glm::distance(line.left, line.right);
    const double along = glm::length(0.5 * (line.left + line.right));
    if (along < 20.0 || along > 0.4 * projector->reach()) continue;
    EXPECT_GE(width, 2.0 * along * tanX);
    // A strip is as wide behind as its far end asks.
    EXPECT_LE(width, 2.0 * along * tanX * 1.001) << along;
  }
}

constexpr int manyAndFew[] = {1024, 128, 17, 2};

TEST(RowFitHard, NothingIsMissedFromAThousandCamerasAnywhere) {
  std::size_t places = 0;
  for (std::uint64_t i = 0; i < 1000; ++i) {
    const test::RandomView v = test::randomView(i, {64, 40});
    SCOPED_TRACE(i);
    places += expectNothingMissed(v.camera, v.water.heightBound(), manyAndFew);
  }
  EXPECT_GT(places, 1000000u);
}

TEST(RowFitHard, NothingIsMissedByOddCameras) {
  for (const double bound : {0.0, 1.5, 40.0}) {
    for (const double z : {-30.0, -1e-3, 0.0, 1e-3, 1.4, 39.0, 500.0, 1e4}) {
      for (const double pitch : {-90.0, -89.9, -45.0, -30.0, -1e-3, 0.0, 30.0, 89.9, 90.0}) {
        for (const double roll : {0.0, 1e-3, 45.0, 90.0, 180.0}) {
          for (const double fov : {1e-3, 1.0, 60.0, 170.0, 179.0}) {
            // At pitch −fov/2 + 60/2 and the like the horizon lies on the picture's edge.
            SCOPED_TRACE(testing::Message() << "bound " << bound << " z " << z << " pitch " << pitch
                                            << " roll " << roll << " fov " << fov);
            expectNothingMissed(cameraAt({1e4, -3e4, z}, pitch, roll, fov), bound,
                                std::array{256, 33});
            if (testing::Test::HasFailure()) return;
          }
        }
      }
    }
  }
}

TEST(RowFitHard, NothingIsMissedWithTheHorizonOnThePicturesEdge) {
  for (const double z : {2.0, 30.0, 5000.0}) {
    const double dip = degreesFromRadians(std::atan(std::sqrt(2.0 * z / earthMeanRadius)));
    for (const double off : {-1e-2, -1e-6, 0.0, 1e-6, 1e-2}) {
      for (const double side : {-30.0, 30.0}) {
        SCOPED_TRACE(testing::Message() << "z " << z << " off " << off << " side " << side);
        expectNothingMissed(cameraAt({0, 0, z}, side - dip + off), 1.0, manyAndFew);
      }
    }
  }
}

}  // namespace
}  // namespace seaway::render
