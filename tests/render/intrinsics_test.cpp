#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <string>

#include "render/compare_frames.h"
#include "render/unproject.h"
#include "surface/input_error.h"
#include "tests/render/hard_views.h"

// Pinholes given in pixels: any principal point, pixels that are not square, drawn by all.
namespace seaway::render {
namespace {

constexpr double rounding = 1e-12;

struct Way {
  std::string name;
  std::function<std::unique_ptr<RenderTechnique>(glm::ivec2 grid)> make;
};

std::vector<Way> allWays() {
  std::vector<Way> ways{
      {"reference", [](glm::ivec2 grid) { return makeReference({.grid = grid}); }},
      {"software", [](glm::ivec2 grid) { return makeSoftwareGrid({.grid = grid}); }},
      {"radial_grid",
       [](glm::ivec2 grid) { return makeRadialGrid({.grid = grid, .displacement = 1.0}); }},
      {"post_process", [](glm::ivec2 grid) { return makePostProcess({.grid = grid}); }}};
  for (const GridVariant variant :
       {GridVariant::cpuVertices, GridVariant::gpu, GridVariant::cpuVerticesGpuNormals,
        GridVariant::marched}) {
    ways.push_back({std::string(gridVariantName(variant)), [=](glm::ivec2 grid) {
                      return makeProjectedGrid(test::sharedContext(),
                                               {.grid = grid, .variant = variant});
                    }});
  }
  return ways;
}

/// What `whole` shows in `size` pixels from `corner` on.
Camera cutOut(const Camera& whole, glm::ivec2 corner, glm::ivec2 size) {
  Camera camera = whole;
  Intrinsics pinhole = whole.pinhole();
  pinhole.cx -= corner.x;
  pinhole.cy -= corner.y;
  camera.intrinsics = pinhole;
  camera.size = size;
  return camera;
}

Camera withPinhole(Camera camera, const Intrinsics& pinhole) {
  camera.intrinsics = pinhole;
  return camera;
}

TEST(Intrinsics, RaysThroughPixelsAreTheInverseOfProjection) {
  Camera camera = test::cameraAt({0, 0, 5.0}, -7.0, 12.0);
  camera.size = {640, 480};
  camera.intrinsics = Intrinsics{500.0, 420.0, 100.25, 700.5};  // its axis lies below the picture
  validate(camera);
  for (const glm::dvec2 pixel : {glm::dvec2(0, 0), {639, 479}, {100.25, 700.5}, {17.5, 300}}) {
    const glm::dvec3 ray = camera.rayThrough(pixel);
    const double axial = glm::dot(ray, camera.forward());
    EXPECT_NEAR(500.0 * -glm::dot(ray, camera.left()) / axial + 100.25, pixel.x, 1e-9);
    EXPECT_NEAR(420.0 * -glm::dot(ray, camera.up()) / axial + 700.5, pixel.y, 1e-9);
    const glm::dvec4 clip = camera.clipFromRelativeWorld() * glm::dvec4(ray * 50.0, 1.0);
    EXPECT_NEAR(0.5 * (clip.x / clip.w + 1.0) * 640, pixel.x + 0.5, 1e-9);
    EXPECT_NEAR(0.5 * (1.0 - clip.y / clip.w) * 480, pixel.y + 0.5, 1e-9);
    const glm::dvec2 screen = 2.0 * (pixel + 0.5) / glm::dvec2(640, 480) - 1.0;
    const glm::dvec3 sum =
        camera.middleRay() + screen.x * camera.rightHalf() - screen.y * camera.upperHalf();
    EXPECT_LE(glm::distance(glm::normalize(sum), ray), rounding);
    // What a pixel shows is brought back to where it lies.
    const glm::dvec3 place = camera.position + ray * 40.0;
    const SeaPoint found = unproject(camera, pixel, 40.0 * axial);
    EXPECT_LE(glm::distance(found.point, glm::dvec2(place)), 1e-9);
  }
}

TEST(Intrinsics, ThoseOfAFieldOfViewAreTheSameCamera) {
  Camera camera = test::cameraAt({0, 0, 5.0}, -7.0, 12.0);
  const Camera same = withPinhole(camera, camera.pinhole());
  EXPECT_LE(glm::distance(same.halfPicture(), camera.halfPicture()), rounding);
  EXPECT_LE(glm::distance(same.pictureMiddle(), {0.0, 0.0}), rounding);
  EXPECT_NEAR(same.pixelAngle(), camera.pixelAngle(), rounding);
  EXPECT_LE(glm::distance(same.rayThrough({3, 7}), camera.rayThrough({3, 7})), rounding);
}

TEST(Intrinsics, APictureOfAnotherSizeShowsTheSame) {
  Camera camera = test::cameraAt({0, 0, 5.0}, -7.0);
  camera.size = {640, 480};
  camera.intrinsics = Intrinsics{500.0, 420.0, 100.25, 700.5};
  Camera large = camera;
  large.size = {1280, 1440};
  large.intrinsics = scaled(*camera.intrinsics, camera.size, large.size);
  for (const glm::dvec2 edge : {glm::dvec2(0, 0), {1, 1}, {0.3, 0.8}}) {
    const glm::dvec2 a = edge * glm::dvec2(640, 480) - 0.5, b = edge * glm::dvec2(1280, 1440) - 0.5;
    EXPECT_LE(glm::distance(camera.rayThrough(a), large.rayThrough(b)), rounding);
  }
}

TEST(Intrinsics, ValuesOutOfRangeAreRefusedWithTheValueNamed) {
  const auto message = [](const Intrinsics& pinhole) -> std::string {
    Camera camera;
    camera.intrinsics = pinhole;
    try {
      validate(camera);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(message({1e6, 1e6, 640, 360}), "");
  EXPECT_EQ(message({1000, 1000, -900, 5000}), "");
  EXPECT_NE(message({0.0, 100, 640, 360}).find("fx = 0 "), std::string::npos);
  EXPECT_NE(message({100, -3.0, 640, 360}).find("fy = -3 "), std::string::npos);
  EXPECT_NE(message({100, std::nan(""), 640, 360}).find("fy"), std::string::npos);
  EXPECT_NE(message({2e7, 2e7, 640, 360}).find("1e7"), std::string::npos);
  EXPECT_NE(message({1e-3, 1e-3, 640, 360}).find("89.9"), std::string::npos);
  EXPECT_NE(message({100, 100, 1e9, 360}).find("89.9"), std::string::npos);
  EXPECT_NE(message({100, 100, std::nan(""), 360}).find("finite"), std::string::npos);
}

/// A box that floats, of triangles counter-clockwise from outside.
Mesh floatingBox() {
  const glm::vec3 least(-3.0f, -1.0f, -0.8f), most(3.0f, 1.0f, 2.0f);
  const auto at = [&](int i) {
    return glm::vec3(i & 1 ? most.x : least.x, i & 2 ? most.y : least.y, i & 4 ? most.z : least.z);
  };
  const int faces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                           {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  Mesh mesh;
  mesh.parts.push_back({{}, glm::vec3(0.7f, 0.3f, 0.2f)});
  for (const auto& f : faces) {
    for (const int i : {f[0], f[1], f[2], f[0], f[2], f[3]}) {
      mesh.parts[0].vertices.push_back(at(i));
    }
  }
  mesh.boundingRadius = 3.3;
  return mesh;
}

class PinholeWays : public ::testing::TestWithParam<int> {};

// With the grid of the whole picture a piece of it holds the same pixels: of waves, an object, its
// mirror image and what of it is under water.
TEST_P(PinholeWays, APieceOfAPictureIsThatPieceDrawnByItself) {
  const Way way = allWays()[static_cast<std::size_t>(GetParam())];
  const WaterSurface water = test::groupSea(0.4, 4.0);
  const Mesh mesh = floatingBox();
  const SceneObject object{.mesh = &mesh, .position = {22.0, 9.5, 0.0}};
  const Camera whole = test::cameraAt({0, 0, 4.0}, -8.0, 3.0, 50.0, {200, 140});
  const glm::ivec2 corner(70, 40), size(90, 70);
  const auto draw = [&](const Camera& camera) {
    EffectLedger effects;
    View view;
    view.water = &water;
    view.time = 3.0;
    view.camera = camera;
    view.gridCamera = &whole;
    view.objects = {&object, 1};
    view.effects = &effects;
    return way.make({96, 192})->draw(view);
  };
  const Frame all = draw(whole), piece = draw(cutOut(whole, corner, size));
  int classes = 0, depths = 0, colours = 0, objects = 0, inside = 0;
  for (int y = 2; y + 2 < size.y; ++y) {  // edges are smoothed by their neighbours
    for (int x = 2; x + 2 < size.x; ++x, ++inside) {
      const std::size_t a = static_cast<std::size_t>(y + corner.y) * whole.size.x + x + corner.x;
      const std::size_t b = static_cast<std::size_t>(y) * size.x + x;
      objects += all.classes[a] == PixelClass::object;
      classes += all.classes[a] != piece.classes[b];
      const float p = all.depth.metres[a], q = piece.depth.metres[b];
      depths += !(p == q || std::abs(p - q) <= 2e-3f * p);
      int apart = 0;
      for (std::size_t c = 0; c < 3; ++c) {
        apart = std::max(apart, std::abs(all.colour.rgb[3 * a + c] - piece.colour.rgb[3 * b + c]));
      }
      colours += apart > 6;
    }
  }
  EXPECT_GT(objects, 100) << "the view misses its object";
  std::printf("%s: of %d pixels other class %d, depth %d, colour %d\n", way.name.c_str(), inside,
              classes, depths, colours);
  // Rounding moves edges of triangles past some pixels' centres; the march of the post-process
  // steps from where each piece's bound says, and `marched` smooths its slopes over pairs of pixels.
  EXPECT_LE(classes, inside / 200);
  EXPECT_LE(depths, inside / 100);
  EXPECT_LE(colours, inside / (way.name == "post_process" ? 20 : 50));
}

struct PinholeView {
  Camera camera;
  Frame truth;
};

/// Cameras that no field of view describes, and what rays find: with 96x192 points.
const std::vector<PinholeView>& pinholeViews(const WaterSurface& water) {
  static const std::vector<PinholeView> views = [&] {
    const Camera base = test::cameraAt({0, 0, 6.0}, -10.0, 8.0, 60.0, {60, 48});
    const Intrinsics pinholes[] = {{60.0, 60.0, 5.0, 40.0},      // towards a corner
                                   {60.0, 24.0, 30.0, 24.0},     // pixels 2.5 times as tall
                                   {80.0, 60.0, -100.0, -30.0},  // outside the picture
                                   {1e6, 1e6, 29.5, 23.5}};      // a telescope: 12 arc seconds
    std::vector<PinholeView> made;
    for (const Intrinsics& pinhole : pinholes) {
      const Camera camera = withPinhole(base, pinhole);
      made.push_back({camera, test::drawnBy(*makeReference({.grid = {96, 192}}), water, camera, 3.0)});
    }
    return made;
  }();
  return views;
}

TEST_P(PinholeWays, DrawsWhatRaysFindWithAnyPrincipalPointAndPixelsOfAnyShape) {
  const Way way = allWays()[static_cast<std::size_t>(GetParam())];
  if (way.name == "cpu_vertices_gpu_normals") GTEST_SKIP() << "its depth is of a coarse mesh";
  const WaterSurface water = test::groupSea(1.2, 6.0);
  const auto technique = way.make({96, 192});
  for (const auto& [camera, truth] : pinholeViews(water)) {
    const Intrinsics pinhole = camera.pinhole();
    const Frame frame = test::drawnBy(*technique, water, camera, 3.0);
    test::expectSane(frame, camera.size);
    const FrameComparison c = compareFrames(camera, frame, truth);
    std::printf("%s, fx %g cx %g: %zu px, rms %.3f, missing %zu, extra %zu, far %zu\n",
                way.name.c_str(), pinhole.fx, pinhole.cx, c.compared, c.positionRms, c.missing,
                c.extra, c.misplaced);
    EXPECT_GT(c.compared, 200u);
    // Rings lie farther apart than rows of the projected grid, and the reference has the latter's
    // waves; a telescope sees less than a spoke.
    const bool hasRings = way.name == "radial_grid" || way.name == "post_process";
    if (hasRings) continue;
    EXPECT_LE(c.missing + c.extra, 4u);
    EXPECT_EQ(c.misplaced, 0u);
    // A pixel of the telescope is 30 µm at the water, whose heights are floats some metres off.
    EXPECT_LE(c.positionRms, pinhole.fx > 1e5 ? 2.0 : 0.5);
  }
}

INSTANTIATE_TEST_SUITE_P(Each, PinholeWays, ::testing::Range(0, 8));

}  // namespace
}  // namespace seaway::render
