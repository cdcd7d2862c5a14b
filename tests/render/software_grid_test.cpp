#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>

#include "render/compare_frames.h"
#include "tests/render/seas.h"

namespace seaway::render {
namespace {

using test::cameraAt;

Frame drawnBy(RenderTechnique& technique, const WaterSurface& water, const Camera& camera,
              std::span<const SceneObject> objects = {}, bool normals = false) {
  EffectLedger effects;
  View view;
  view.water = &water;
  view.time = 2.0;
  view.camera = camera;
  view.light.sunElevation = 0.4;
  view.light.sunDirection = 0.6;
  view.objects = objects;
  view.effects = &effects;
  view.wantsNormals = normals;
  return technique.draw(view);
}

Mesh tetrahedron() {
  const glm::vec3 a(2, 0, -1), b(-1, 2, -1), c(-1, -2, -1), d(0, 0, 2);
  Mesh mesh;
  mesh.parts.push_back({{a, c, b, a, b, d, b, c, d, c, a, d}, glm::vec3(0.7f, 0.1f, 0.1f)});
  mesh.boundingRadius = 2.3;
  return mesh;
}

TEST(SoftwareGrid, PictureDoesNotDependOnTheNumberOfThreads) {
  const WaterSurface water = test::moderateSea();
  const Mesh mesh = tetrahedron();
  const Camera camera = cameraAt({0, 0, 4}, -8.0, 5.0, 60.0, {203, 131});
  const SceneObject object{&mesh, camera.position + 20.0 * camera.forward(), {1, 0, 0, 0}};
  const auto technique = makeSoftwareGrid({.grid = {97, 130}});
  Frame frames[3];
  const std::size_t threads[3] = {1, 2, 5};
  for (int i = 0; i < 3; ++i) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads[i]);
    frames[i] = drawnBy(*technique, water, camera, {&object, 1}, true);
  }
  for (int i = 1; i < 3; ++i) {
    EXPECT_EQ(frames[0].colour.rgb, frames[i].colour.rgb);
    EXPECT_EQ(frames[0].depth.metres, frames[i].depth.metres);
    EXPECT_EQ(frames[0].normals, frames[i].normals);
  }
}

/// Share of pixels of which some channel differs by more than `most` of 255.
double shareBeyond(const Frame& a, const Frame& b, int most) {
  std::size_t beyond = 0;
  for (std::size_t i = 0; i < a.classes.size(); ++i) {
    int largest = 0;
    for (std::size_t c = 3 * i; c < 3 * i + 3; ++c) {
      largest = std::max(largest, std::abs(int{a.colour.rgb[c]} - int{b.colour.rgb[c]}));
    }
    beyond += largest > most;
  }
  return static_cast<double>(beyond) / static_cast<double>(a.classes.size());
}

struct Scenery {
  const char* what;
  glm::dvec3 eye;
  double pitch_deg;
};

// One text shades both pictures. What is left: the processor's estimates of roots and quotients
// (2⁻²²) and its exponential (2e-6), the table of tones (a third of a byte), the half floats of
// OpenGL's radiance (2⁻¹¹, half a byte at white) and its texture filter, whose weights have 8 bits
// (a 256th of the step between neighbouring texels): two bytes.
TEST(ShadingParity, OpenGlAndTheProcessorGiveTheSameColours) {
  const WaterSurface still = test::stillSea();
  const auto inGl = makeProjectedGrid(test::sharedContext(), {.grid = {128, 128}});
  const auto onProcessor = makeSoftwareGrid({.grid = {128, 128}});
  for (const Scenery& s : {Scenery{"sky", {0, 0, 5}, 50.0}, Scenery{"water", {0, 0, 8}, -40.0},
                           Scenery{"underside", {0, 0, -6}, 55.0}}) {
    const Camera camera = cameraAt(s.eye, s.pitch_deg, 0.0, 50.0, {240, 160});
    const Frame a = drawnBy(*inGl, still, camera), b = drawnBy(*onProcessor, still, camera);
    const double beyond = shareBeyond(a, b, 2);
    std::printf("%s: %.4f of the pixels differ by more than 2 of 255\n", s.what, beyond);
    // Slopes reach OpenGL's shading as half floats: glints that sit on the edge of a texel differ.
    EXPECT_LE(beyond, 0.005) << s.what;
  }
}

TEST(ShadingParity, ObjectsAreLitAlike) {
  const WaterSurface still = test::stillSea();
  const Mesh mesh = tetrahedron();
  const Camera camera = cameraAt({0, 0, 8}, -5.0, 0.0, 40.0, {240, 160});
  const SceneObject object{&mesh, camera.position + 12.0 * camera.forward(), {1, 0, 0, 0}};
  const auto inGl = makeProjectedGrid(test::sharedContext(), {.grid = {64, 64}});
  const auto onProcessor = makeSoftwareGrid({.grid = {64, 64}});
  const Frame a = drawnBy(*inGl, still, camera, {&object, 1});
  const Frame b = drawnBy(*onProcessor, still, camera, {&object, 1});
  const auto isObject = [&](const Frame& frame, std::size_t i) {
    return frame.classes[i] == PixelClass::object;
  };
  // Rims are mixed by coverage on the processor, smoothed along the edge after OpenGL.
  const auto isInner = [&](std::size_t i) {
    for (const int row : {-1, 0, 1}) {
      for (const int column : {-1, 0, 1}) {
        const std::size_t beside = i + row * camera.size.x + column;
        if (!isObject(a, beside) || !isObject(b, beside)) return false;
      }
    }
    return true;
  };
  std::size_t both = 0, either = 0, inner = 0, alike = 0;
  for (std::size_t i = 0; i < a.classes.size(); ++i) {
    either += isObject(a, i) || isObject(b, i);
    if (!isObject(a, i) || !isObject(b, i)) continue;
    ++both;
    if (!isInner(i)) continue;
    ++inner;
    int largest = 0;
    for (std::size_t c = 3 * i; c < 3 * i + 3; ++c) {
      largest = std::max(largest, std::abs(int{a.colour.rgb[c]} - int{b.colour.rgb[c]}));
    }
    alike += largest <= 2;
  }
  EXPECT_GT(both, 1000u);
  EXPECT_LE(either - both, both / 50);  // rims, by a different rule for pixels on edges
  EXPECT_GT(inner, 1000u);
  EXPECT_GE(alike, inner * 97 / 100);  // the others: edges between faces
}

TEST(SoftwareGrid, ShowsTheSameSeaAsTheMeshThroughOpenGl) {
  const WaterSurface storm = test::stormSea();
  const Camera camera = cameraAt({30, -20, 9}, -6.0, 8.0, 60.0, {240, 160});
  const auto inGl = makeProjectedGrid(test::sharedContext(), {.grid = {200, 300}});
  const auto onProcessor = makeSoftwareGrid({.grid = {200, 300}});
  const Frame a = drawnBy(*inGl, storm, camera, {}, true);
  const Frame b = drawnBy(*onProcessor, storm, camera, {}, true);
  const FrameComparison c = compareFrames(camera, b, a);
  EXPECT_GT(c.compared, 10000u);
  // The same triangles: what differs is rounding.
  EXPECT_LT(c.positionRms, 0.02);
  EXPECT_LE(c.missing + c.extra, 40u);  // pixels on the sky line that fall to either side
}

TEST(SoftwareGrid, FlatHorizonLiesAtTheDipOfTheSphere) {
  const WaterSurface still = test::stillSea();
  const auto technique = makeSoftwareGrid({.grid = {128, 1024}});
  for (const double height : {1.0, 10.0, 100.0, 1000.0, 10000.0}) {
    Camera camera = cameraAt({0, 0, height}, 0.0, 0.0, 10.0, {9, 720});
    const double dip = std::acos(earthMeanRadius / (earthMeanRadius + height));
    camera.worldFromCamera = attitude(0.4, -dip, 0.0);  // the horizon between the middle rows
    const double pixel = 2.0 * std::tan(0.5 * camera.verticalFieldOfView) / camera.size.y;
    // Where the picture turns from water to sky, to a tenth of a pixel: by raising the camera's
    // axis a tenth of a pixel either way.
    for (const double off : {-0.1, 0.1}) {
      camera.worldFromCamera = attitude(0.4, -dip + (0.5 - off) * pixel, 0.0);
      const Frame frame = drawnBy(*technique, still, camera);
      const std::size_t row = 360;  // its centre looks half a pixel below the axis
      const bool water = frame.classes[row * 9 + 4] == PixelClass::water;
      EXPECT_EQ(water, off > 0.0) << height << " m, " << off;
    }
  }
}

TEST(NaiveGrid, EndsWhereItsSideEnds) {
  const WaterSurface water = test::moderateSea();
  const auto naive = makeNaiveGrid({.grid = {200, 200}, .side = 400.0});
  const Frame frame = drawnBy(*naive, water, cameraAt({0, 0, 5}, 0.0));
  double farthest = 0.0;
  for (std::size_t i = 0; i < frame.classes.size(); ++i) {
    if (frame.classes[i] == PixelClass::water) {
      farthest = std::max<double>(farthest, frame.depth.metres[i]);
    }
  }
  EXPECT_GT(farthest, 150.0);
  EXPECT_LT(farthest, 300.0);  // half the diagonal
  EXPECT_LT(frame.stats.vertexEfficiency, 0.3);
}

}  // namespace
}  // namespace seaway::render
