#include "render/software/object_edges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "tests/render/seas.h"

// What is thinner than a pixel, and the rims of what is not.
namespace seaway::render {
namespace {

constexpr glm::ivec2 size(120, 60);

/// A flat bar across the view 100 m ahead, `thickness` pixels high, its ends `slope` pixels apart.
Mesh bar(double thickness, double slope) {
  const float pixel = static_cast<float>(2.0 * 100.0 * std::tan(radiansFromDegrees(10.0)) / size.y);
  const float half = 0.5f * pixel * static_cast<float>(thickness), end = 50.0f * pixel;
  const float rise = 0.5f * pixel * static_cast<float>(slope);
  const glm::vec3 a(0, end, -rise - half), b(0, -end, rise - half), c(0, -end, rise + half),
      d(0, end, -rise + half);
  Mesh mesh;
  mesh.parts.push_back({{a, b, c, a, c, d}, glm::vec3(0.9f, 0.05f, 0.05f)});
  mesh.boundingRadius = 100.0;
  return mesh;
}

/// A picture of sky and of the mesh, if any.
Frame picture(const Mesh* mesh) {
  const WaterSurface still = test::stillSea();
  EffectLedger effects;
  View view;
  view.water = &still;
  view.camera.position = {0.0, 0.0, 100.0};
  view.camera.worldFromCamera = attitude(0.0, radiansFromDegrees(30.0), 0.0);
  view.camera.verticalFieldOfView = radiansFromDegrees(20.0);
  view.camera.size = size;
  view.effects = &effects;
  const SceneObject object{mesh, view.camera.position + 100.0 * view.camera.forward(),
                           view.camera.worldFromCamera};
  if (mesh != nullptr) view.objects = {&object, 1};
  return makeSoftwareGrid({.grid = {16, 16}})->draw(view);
}

/// By how much green each column of the picture is darker with the mesh than without it.
std::vector<double> darkness(const Mesh& mesh) {
  const Frame with = picture(&mesh), without = picture(nullptr);
  std::vector<double> columns(size.x, 0.0);
  for (int y = 0; y < size.y; ++y) {
    for (int x = 0; x < size.x; ++x) {
      const std::size_t green = 3 * (static_cast<std::size_t>(y) * size.x + x) + 1;
      columns[x] += without.colour.rgb[green] - with.colour.rgb[green];
    }
  }
  return columns;
}

TEST(ObjectEdges, ABarThinnerThanAPixelIsALineWithoutGaps) {
  const std::vector<double> whole = darkness(bar(1.0, 5.0));
  for (const double thickness : {0.6, 0.3}) {
    const std::vector<double> columns = darkness(bar(thickness, 5.0));
    double sum = 0.0, of = 0.0;
    for (int x = 15; x < 105; ++x) {
      sum += columns[x];
      of += whole[x];
      // Eight samples: one more or less is an eighth of a whole pixel.
      EXPECT_GT(columns[x], 0.1 * whole[x]) << thickness << " px, column " << x;
    }
    // As strong as it is thick.
    EXPECT_NEAR(sum / of, thickness, 0.06);
  }
}

TEST(ObjectEdges, FacesThatShareAnEdgeLetNothingThrough) {
  const Mesh mesh = bar(40.0, 7.0);  // two triangles
  const Frame frame = picture(&mesh);
  int least = 255, most = 0;
  for (int y = 16; y < size.y - 16; ++y) {
    for (int x = 15; x < 105; ++x) {
      const int green = frame.colour.rgb[3 * (static_cast<std::size_t>(y) * size.x + x) + 1];
      least = std::min(least, green);
      most = std::max(most, green);
    }
  }
  EXPECT_LE(most - least, 2);  // haze
}

TEST(ObjectEdges, ARimIsMixedByThePartOfThePixelThatItCovers) {
  const Mesh mesh = bar(20.0, 3.0);
  const std::vector<double> columns = darkness(mesh);
  // Level by level: along the rim the column's sum goes evenly, without steps of whole pixels.
  const double perPixel = columns[60] / 20.0;
  for (int x = 16; x < 105; ++x) {
    EXPECT_LT(std::abs(columns[x] - columns[x - 1]), 0.6 * perPixel) << x;
  }
}

}  // namespace
}  // namespace seaway::render
