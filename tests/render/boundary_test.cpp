#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <glm/geometric.hpp>
#include <memory>

#include "surface/curvature.h"
#include "tests/render/seas.h"

// Where the sea ends: shores and open hulls, in every way of drawing.
namespace seaway::render {
namespace {

struct Way {
  std::string name;
  std::function<std::unique_ptr<RenderTechnique>()> make;
};

std::vector<Way> allWays(glm::ivec2 grid) {
  std::vector<Way> ways{
      {"software", [=] { return makeSoftwareGrid({.grid = grid}); }},
      {"naive_grid", [=] { return makeNaiveGrid({.grid = grid, .side = 400.0}); }},
      {"radial_grid", [=] { return makeRadialGrid({.grid = grid}); }},
      {"post_process", [=] { return makePostProcess({.grid = grid}); }},
      {"reference", [=] { return makeReference({.grid = grid}); }}};
  for (const GridVariant variant : {GridVariant::cpuVertices, GridVariant::gpu,
                                    GridVariant::cpuVerticesGpuNormals, GridVariant::marched}) {
    ways.push_back({std::string(gridVariantName(variant)), [=] {
                      return makeProjectedGrid(test::sharedContext(),
                                               {.grid = grid, .variant = variant});
                    }});
  }
  return ways;
}

struct Picture {
  Frame frame;
  std::vector<EffectReport> report;
  const EffectReport& operator[](Effect effect) const {
    return report[static_cast<std::size_t>(effect)];
  }
  PixelClass at(int x, int y) const {
    return frame.classes[static_cast<std::size_t>(y) * frame.depth.size.x + x];
  }
};

Picture picture(RenderTechnique& technique, const WaterSurface& water, const Camera& camera,
                std::span<const SceneObject> objects = {}, const EffectSettings& settings = {}) {
  EffectLedger effects(settings);
  View view;
  view.water = &water;
  view.time = 3.0;
  view.camera = camera;
  view.objects = objects;
  view.effects = &effects;
  Picture result;
  result.frame = technique.draw(view);
  result.report = effects.report();
  return result;
}

/// A lake of 80 m with a bay from the north that is land, and an island.
std::shared_ptr<const WaterOutline> lake(glm::dvec2 middle) {
  std::vector<OutlinePolygon> polygons{
      {{{{-40, -40}, {40, -40}, {40, 40}, {12, 40}, {12, 5}, {-12, 5}, {-12, 40}, {-40, 40}},
        {{-30, -30}, {-10, -33}, {-14, -12}, {-31, -15}}}}};
  for (auto& ring : polygons[0].rings) {
    for (glm::dvec2& point : ring) point += middle;
  }
  return std::make_shared<const WaterOutline>(polygons);
}

WaterSurface lakeSea(glm::dvec2 middle) {
  WaterSurface water = test::windSea(0.4, 12.0);
  water.setOutline(lake(middle));
  return water;
}

/// Where a pixel's ray meets still water; the camera looks down.
glm::dvec2 placeOf(const Camera& camera, glm::dvec2 pixel) {
  const glm::dvec3 ray = camera.rayThrough(pixel);
  return glm::dvec2(camera.position) + glm::dvec2(ray) * (camera.position.z / -ray.z);
}

TEST(Boundary, FromStraightAboveWaterIsWhatTheOutlineHoldsToAPixel) {
  const glm::dvec2 middle(3000.0, -500.0);
  const WaterSurface water = lakeSea(middle);
  Camera camera =
      test::cameraAt({middle.x + 1.3, middle.y - 2.1, 90.0}, -90.0, 0.0, 60.0, {200, 160});
  for (const Way& way : allWays({128, 128})) {
    SCOPED_TRACE(way.name);
    const Picture p = picture(*way.make(), water, camera);
    int seen[2] = {0, 0}, wrong = 0;
    for (int y = 0; y < camera.size.y; ++y) {
      for (int x = 0; x < camera.size.x; ++x) {
        // A crest of 0.4 m moves what is seen by 0.3 m at the picture's corners, half a pixel.
        int inside = 0;
        for (const int dx : {-1, 0, 1}) {
          for (const int dy : {-1, 0, 1}) {
            inside += water.outline()->contains(placeOf(camera, {x + dx, y + dy}));
          }
        }
        if (inside != 0 && inside != 9) continue;
        const bool wet = inside == 9;
        ++seen[wet];
        wrong += p.at(x, y) != (wet ? PixelClass::water : PixelClass::ground);
      }
    }
    EXPECT_GT(seen[0], 10000);
    EXPECT_GT(seen[1], 7000);
    EXPECT_EQ(wrong, 0);
    EXPECT_EQ(p[Effect::outline].state, EffectState::on);
    EXPECT_GT(p[Effect::outline].memoryBytes, 0u);
  }
}

/// Pixels of one class that are nowhere near (2 pixels) any of that class in the other picture.
long strays(const Picture& one, const Picture& other) {
  const glm::ivec2 size = one.frame.depth.size;
  long found = 0;
  for (int y = 0; y < size.y; ++y) {
    for (int x = 0; x < size.x; ++x) {
      bool near = false;
      for (int v = std::max(0, y - 2); v <= std::min(size.y - 1, y + 2); ++v) {
        for (int u = std::max(0, x - 2); u <= std::min(size.x - 1, x + 2); ++u) {
          near = near || other.at(u, v) == one.at(x, y);
        }
      }
      found += !near;
    }
  }
  return found;
}

TEST(Boundary, FromTheShoreEveryTechniqueShowsTheReferencesShores) {
  const WaterSurface water = lakeSea({0.0, 0.0});
  // Low over the ground south of the lake, looking over it and the island.
  const Camera camera = test::cameraAt({-70.0, -45.0, 3.0}, -4.0, 3.0, 50.0, {240, 150});
  const Picture truth = picture(*makeReference({.grid = {256, 256}}), water, camera);
  const auto count = [&](PixelClass wanted) {
    return std::count(truth.frame.classes.begin(), truth.frame.classes.end(), wanted);
  };
  EXPECT_GT(count(PixelClass::water), 1000);
  EXPECT_GT(count(PixelClass::ground), 10000);
  EXPECT_GT(count(PixelClass::sky), 5000);
  for (const Way& way : allWays({256, 256})) {
    // Beyond its side the naive grid has no water; the coarse mesh of an eighth has other chords.
    if (way.name == "naive_grid" || way.name == "cpu_vertices_gpu_normals") continue;
    SCOPED_TRACE(way.name);
    const Picture p = picture(*way.make(), water, camera);
    // The figure for silhouettes of grids against the reference.
    EXPECT_LE(strays(p, truth) + strays(truth, p), 0.003 * 240 * 150);
  }
}

TEST(Boundary, GroundLiesOnTheCurvedPlaneOfStillWater) {
  const WaterSurface water = lakeSea({5000.0, 0.0});  // out of view
  const Camera camera = test::cameraAt({0.0, 0.0, 50.0}, -10.0, 0.0, 60.0, {64, 48});
  for (const Way& way : allWays({64, 64})) {
    SCOPED_TRACE(way.name);
    const Picture p = picture(*way.make(), water, camera);
    for (int y = 0; y < 48; ++y) {
      const glm::dvec3 ray = camera.rayThrough({20, y});
      const double cosine = glm::dot(ray, camera.forward());
      const double range = p.frame.depth.metres[y * 64 + 20] / cosine;
      if (p.at(20, y) == PixelClass::sky) {
        EXPECT_GT(ray.z, -0.004);  // the dip of the horizon from 50 m is 0.00396 rad
        continue;
      }
      ASSERT_EQ(p.at(20, y), PixelClass::ground);
      const double height = 50.0 + range * ray.z + seaDrop(range * glm::length(glm::dvec2(ray)));
      // A float's 24 bits of range, and as much of its square's root where the ray grazes.
      EXPECT_NEAR(height, 0.0, 1e-5 * range + 1e-3) << y;
    }
  }
}

TEST(Boundary, WithoutAnOutlineNothingIsMadeOrDone) {
  const WaterSurface water = test::windSea(0.4, 12.0);
  const Camera camera = test::cameraAt({0.0, 0.0, 5.0}, -10.0);
  for (const Way& way : allWays({32, 32})) {
    SCOPED_TRACE(way.name);
    const Picture p = picture(*way.make(), water, camera);
    for (const Effect effect : {Effect::outline, Effect::hullMask}) {
      EXPECT_EQ(p[effect].state, EffectState::idle);
      EXPECT_EQ(p[effect].memoryBytes, 0u);
      EXPECT_EQ(p[effect].costMicroseconds, 0.0);
    }
    for (const auto& [pass, ms] : p.frame.stats.passesMs) {
      EXPECT_NE(pass, "ground");
      EXPECT_NE(pass, "hull_mask");
    }
  }
}

TEST(Boundary, WaterInsideAnOutlineHasTheDepthOfAnEndlessSea) {
  WaterSurface bounded = test::windSea(0.4, 12.0);
  bounded.setOutline(lake({0.0, 0.0}));
  const WaterSurface endless{bounded.waves()};
  const Camera camera = test::cameraAt({25.0, -20.0, 20.0}, -90.0, 0.0, 40.0, {96, 64});
  for (const Way& way : allWays({64, 64})) {
    if (way.name == "naive_grid") continue;  // its cells of 6 m reach over the shore
    SCOPED_TRACE(way.name);
    const Picture with = picture(*way.make(), bounded, camera);
    const Picture without = picture(*way.make(), endless, camera);
    EXPECT_EQ(std::count(with.frame.classes.begin(), with.frame.classes.end(), PixelClass::water),
              96 * 64);
    EXPECT_EQ(with.frame.depth.metres, without.frame.depth.metres);
    EXPECT_EQ(with.frame.colour.rgb, without.frame.colour.rgb);
  }
}

/// An open box boat, 8 m by 3 m, its floor 0.3 m below the waterline.
Mesh openBoat() {
  const auto quad = [](std::vector<glm::vec3>& to, glm::vec3 a, glm::vec3 b, glm::vec3 c,
                       glm::vec3 d) {
    to.insert(to.end(), {a, b, c, a, c, d});
  };
  Mesh mesh;
  Mesh::Part part{{}, glm::vec3(0.6f, 0.2f, 0.1f)};
  const float x = 4.0f, y = 1.5f, in = 0.9f, low = -0.6f, floor = -0.3f, top = 0.7f;
  for (const float s : {-1.0f, 1.0f}) {
    quad(part.vertices, {s * x, -y, low}, {s * x, y, low}, {s * x, y, top}, {s * x, -y, top});
    quad(part.vertices, {-x, s * y, low}, {x, s * y, low}, {x, s * y, top}, {-x, s * y, top});
    quad(part.vertices, {s * x * in, -y * in, floor}, {s * x * in, y * in, floor},
         {s * x * in, y * in, top}, {s * x * in, -y * in, top});
    quad(part.vertices, {-x * in, s * y * in, floor}, {x * in, s * y * in, floor},
         {x * in, s * y * in, top}, {-x * in, s * y * in, top});
  }
  quad(part.vertices, {-x * in, -y * in, floor}, {x * in, -y * in, floor}, {x * in, y * in, floor},
       {-x * in, y * in, floor});
  mesh.parts.push_back(std::move(part));
  mesh.hollows.push_back({{{1, 0, 0, x * in},
                           {-1, 0, 0, x * in},
                           {0, 1, 0, y * in},
                           {0, -1, 0, y * in},
                           {0, 0, -1, -floor},
                           {0, 0, 1, top}}});
  mesh.boundingRadius = 4.5;
  return mesh;
}

/// Water pixels among those whose ray meets the boat's inside at still-water level, and how many
/// such pixels there are.
std::pair<int, int> waterInside(const Picture& p, const Camera& camera, const SceneObject& boat) {
  int water = 0, all = 0;
  for (int y = 0; y < camera.size.y; ++y) {
    for (int x = 0; x < camera.size.x; ++x) {
      const glm::dvec3 off(placeOf(camera, {x, y}) - glm::dvec2(boat.position), -boat.position.z);
      const glm::dvec3 body = glm::inverse(boat.worldFromBody) * off;
      if (std::abs(body.x) > 3.4 || std::abs(body.y) > 1.2) continue;
      ++all;
      water += p.at(x, y) == PixelClass::water;
    }
  }
  return {water, all};
}

TEST(Boundary, NoWaterIsSeenInsideAnOpenHullWhoseFloorIsBelowTheWaterline) {
  const WaterSurface water = test::windSea(0.1, 6.0);
  const Mesh mesh = openBoat();
  const SceneObject boat{&mesh, {500.0, 200.0, 0.02}, attitude(0.7, 0.03, -0.02)};
  const Camera camera = test::cameraAt({499.0, 200.5, 14.0}, -90.0, 0.0, 45.0, {160, 120});
  for (const Way& way : allWays({96, 96})) {
    SCOPED_TRACE(way.name);
    const Picture masked = picture(*way.make(), water, camera, {&boat, 1});
    const auto [inside, all] = waterInside(masked, camera, boat);
    EXPECT_GT(all, 1500);
    EXPECT_EQ(inside, 0);
    EXPECT_EQ(masked[Effect::hullMask].state, EffectState::on);
    // Without the mask the floor is drowned: the test can fail.
    EffectSettings settings{};
    settings[static_cast<std::size_t>(Effect::hullMask)] = EffectSetting::off;
    const Picture plain = picture(*way.make(), water, camera, {&boat, 1}, settings);
    EXPECT_GT(waterInside(plain, camera, boat).first, all / 2);
    EXPECT_EQ(plain[Effect::hullMask].state, EffectState::off);
  }
}

TEST(BoundaryHard, FromInsideTheOpenHullTheSeaIsSeenOverItsSidesOnly) {
  const WaterSurface water = test::windSea(0.1, 6.0);
  const Mesh mesh = openBoat();
  const SceneObject boat{&mesh, {0.0, 0.0, 0.0}};
  for (const Way& way : allWays({96, 96})) {
    SCOPED_TRACE(way.name);
    // The eye below the gunwale: only the inside of the boat and sky.
    Camera camera = test::cameraAt({0.0, 0.0, 0.35}, -20.0, 0.0, 40.0, {80, 60});
    const Picture low = picture(*way.make(), water, camera, {&boat, 1});
    EXPECT_EQ(std::count(low.frame.classes.begin(), low.frame.classes.end(), PixelClass::water), 0);
    // The eye above it: sea beyond the side, at its right distance.
    camera.position.z = 1.8;
    const Picture high = picture(*way.make(), water, camera, {&boat, 1});
    EXPECT_GT(std::count(high.frame.classes.begin(), high.frame.classes.end(), PixelClass::water),
              50);
  }
}

}  // namespace
}  // namespace seaway::render
