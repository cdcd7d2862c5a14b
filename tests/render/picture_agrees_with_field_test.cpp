#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "render/unproject.h"
#include "surface/surface_ray.h"
#include "tests/render/seas.h"

// The picture and the query answer from one field: what the depth image says the water's height is,
// asked again of the field. And the picture against the ray-march, which knows no grid.
namespace seaway::render {
namespace {

struct Difference {
  double rootMeanSquare = 0.0, ninetyNinth = 0.0;
};

/// Height of unprojected water pixels minus the field's, m. `within` m of the camera.
Difference heightDifference(const WaterSurface& water, const Camera& camera, double time, int grid,
                            double within) {
  const Frame frame = test::drawn(water, camera, time, {.grid = {grid, grid}});
  std::vector<double> differences;
  double squares = 0.0;
  for (int y = 0; y < camera.size.y; ++y) {
    for (int x = 0; x < camera.size.x; ++x) {
      const std::size_t i = static_cast<std::size_t>(y) * camera.size.x + x;
      if (frame.classes[i] != PixelClass::water || frame.depth.metres[i] > within) continue;
      const SeaPoint point = unproject(camera, {x, y}, frame.depth.metres[i]);
      const double difference = point.height - water.sample(point.point, time).height;
      differences.push_back(std::abs(difference));
      squares += difference * difference;
    }
  }
  EXPECT_GT(differences.size(), 1000u);
  const auto nth = differences.begin() + differences.size() * 99 / 100;
  std::nth_element(differences.begin(), nth, differences.end());
  return {std::sqrt(squares / differences.size()), *nth};
}

TEST(PictureAgreesWithField, HeightsDifferByLessTheFinerTheGrid) {
  const WaterSurface water = test::moderateSea();
  const Camera camera = test::cameraAt({100.0, 50.0, 6.0}, -15.0, 0.0, 50.0, {320, 180});
  double before = 1e9;
  for (const int grid : {64, 128, 256, 512}) {
    const Difference d = heightDifference(water, camera, 3.0, grid, 60.0);
    std::printf("grid %d: rms %.4f m, 99 %% below %.4f m\n", grid, d.rootMeanSquare, d.ninetyNinth);
    RecordProperty("rms_mm_grid_" + std::to_string(grid), std::to_string(1e3 * d.rootMeanSquare));
    // Linear interpolation errs with the square of the spacing where waves are resolved, more
    // slowly where the shortest are not: halving must gain at least a third.
    EXPECT_LT(d.rootMeanSquare, 0.67 * before);
    before = d.rootMeanSquare;
  }
  EXPECT_LT(before, 0.004);
}

TEST(PictureAgreesWithField, StormHeightsAgreeToCentimetresNearTheCamera) {
  const WaterSurface water = test::stormSea();
  const Camera camera = test::cameraAt({0.0, 0.0, 15.0}, -15.0, 0.0, 50.0, {320, 180});
  const Difference d = heightDifference(water, camera, 3.0, 256, 150.0);
  std::printf("storm: rms %.4f m, 99 %% below %.4f m\n", d.rootMeanSquare, d.ninetyNinth);
  EXPECT_LT(d.rootMeanSquare, 0.05);
}

TEST(PictureAgreesWithField, StillWaterDiffersByDepthRoundingAlone) {
  const WaterSurface water = test::stillSea();
  const Camera camera = test::cameraAt({1e4, 2e4, 6.0}, -15.0, 10.0, 50.0, {320, 180});
  const Difference d = heightDifference(water, camera, 0.0, 64, 400.0);
  // The plane's triangles are flat, the sea between them bulges by spacing²/8R: 0.2 mm at the
  // 150 m or so between the last rows within 400 m.
  EXPECT_LT(d.rootMeanSquare, 5e-4);
}

TEST(PictureAgreesWithField, StormPictureShowsWhatARayMarchFinds) {
  const WaterSurface storm = test::stormSea();
  const Camera camera = test::cameraAt({30.0, -20.0, 7.0}, -3.0, 8.0, 60.0, {160, 90});
  const double time = 4.0;
  const SurfaceAtTime now = storm.at(time);
  const Frame frame = test::drawn(storm, camera, time, {.grid = {512, 512}});
  int otherClass = 0, compared = 0;
  std::vector<double> errors;
  for (int y = 0; y < camera.size.y; ++y) {
    for (int x = 0; x < camera.size.x; ++x) {
      const std::size_t i = static_cast<std::size_t>(y) * camera.size.x + x;
      const glm::dvec3 ray = camera.rayThrough({x, y});
      const auto distance = distanceToWater(now, camera.position, ray);
      const bool water = frame.classes[i] == PixelClass::water;
      otherClass += water != distance.has_value();
      if (!water || !distance) continue;
      ++compared;
      const double axial = *distance * glm::dot(ray, camera.forward());
      errors.push_back(std::abs(frame.depth.metres[i] / axial - 1.0));
    }
  }
  std::sort(errors.begin(), errors.end());
  const double median = errors[errors.size() / 2], ninety = errors[errors.size() * 9 / 10];
  std::printf(
      "storm against ray-march: %d of %d pixels of the other class, depth error median "
      "%.4f, 90 %% below %.4f\n",
      otherClass, 160 * 90, median, ninety);
  EXPECT_GT(compared, 5000);
  // The sky line is as long as the picture is wide; a pixel of it may fall to either side.
  EXPECT_LE(otherClass, 160);
  EXPECT_LT(median, 0.002);
  EXPECT_LT(ninety, 0.05);  // grazing rays slide over crests
}

}  // namespace
}  // namespace seaway::render
