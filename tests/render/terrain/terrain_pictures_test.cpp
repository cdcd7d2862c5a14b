#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>

#include "render/fresnel.h"
#include "render/local_light.h"
#include "surface/constants.h"
#include "surface/curvature.h"
#include "tests/render/terrain/grounds.h"

// Islands, shores and sea bed, in every way of drawing.
namespace seaway::render {
namespace {

using test::allWays;
using test::looking;
using test::picture;
using test::Picture;
using test::Way;

/// A round hill of 30 m on a bed 12 m deep; its shore is 63 m from the middle.
double hill(glm::dvec2 p) { return 30.0 * std::exp(-glm::dot(p, p) / 4500.0) - 12.0; }

WaterSurface islandSea(WaterSurface water) {
  water.setTerrain(test::ground({65, 65}, 4.0, hill));
  return water;
}

/// Where a pixel's ray meets still water; the camera looks down.
glm::dvec2 placeOf(const Camera& camera, glm::dvec2 pixel) {
  const glm::dvec3 ray = camera.rayThrough(pixel);
  return glm::dvec2(camera.position) + glm::dvec2(ray) * (camera.position.z / -ray.z);
}

TEST(TerrainPictures, FromStraightAboveWaterIsWhereQueriesFindItToAPixel) {
  const WaterSurface water = islandSea(test::windSea(0.1, 8.0));
  const Camera camera = looking({3.0, -2.0, 190.0}, 0.0, -90.0, 50.0, {160, 120});
  for (const Way& way : allWays({128, 128})) {
    SCOPED_TRACE(way.name);
    const Picture p = picture(*way.make(), water, camera);
    int seen[2] = {0, 0}, wrong = 0;
    for (int y = 0; y < 120; ++y) {
      for (int x = 0; x < 160; ++x) {
        int dry = 0;
        for (const int dx : {-1, 0, 1}) {
          for (const int dy : {-1, 0, 1}) {
            dry +=
                has(water.sample(placeOf(camera, {x + dx, y + dy}), 3.0).status, SampleStatus::dry);
          }
        }
        if (dry != 0 && dry != 9) continue;
        const glm::dvec2 here = placeOf(camera, {x, y});
        // What stands h above the water is seen h/190 farther out: only the shore is compared.
        if (water.terrain()->heightAt(here) > 3.0) continue;
        ++seen[dry == 0];
        wrong += p.at(x, y) != (dry == 0 ? PixelClass::water : PixelClass::ground);
      }
    }
    EXPECT_GT(seen[0], 200);
    EXPECT_GT(seen[1], 5000);
    EXPECT_EQ(wrong, 0);
    EXPECT_EQ(p[Effect::terrain].state, EffectState::on);
    EXPECT_GT(p[Effect::terrain].memoryBytes, 0u);
  }
}

TEST(TerrainPictures, GroundHasTheDepthOfTheMapsHeights) {
  const WaterSurface water = islandSea(test::stillSea());
  const Camera camera = looking({-160.0, 0.0, 25.0}, 0.0, -6.0, 45.0, {160, 120});
  for (const Way& way : allWays({64, 64})) {
    SCOPED_TRACE(way.name);
    const Picture p = picture(*way.make(), water, camera);
    int compared = 0;
    for (int y = 0; y < 120; y += 3) {
      for (int x = 0; x < 160; x += 3) {
        if (p.at(x, y) != PixelClass::ground) continue;
        const glm::dvec3 ray = camera.rayThrough({x, y});
        const double range = p.frame.depth.metres[p.index(x, y)] / glm::dot(ray, camera.forward());
        const glm::dvec2 place = glm::dvec2(camera.position) + range * glm::dvec2(ray);
        const double height =
            camera.position.z + range * ray.z + seaDrop(range * glm::length(glm::dvec2(ray)));
        // 0.7 pixels of the tolerance, 1/190 rad each, and a quarter of a cell's twist.
        EXPECT_NEAR(height, water.terrain()->heightAt(place), 0.7 * range / 145.0 + 0.05);
        ++compared;
      }
    }
    EXPECT_GT(compared, 150);
  }
}

TEST(TerrainPictures, AFarIslandSinksBelowTheHorizonAsTheSeasCurvatureHasIt) {
  // A plateau of 60 m, 300 m each way.
  WaterSurface water = test::stillSea();
  water.setTerrain(test::ground({33, 33}, 20.0, [](glm::dvec2 p) {
    return std::max(std::abs(p.x), std::abs(p.y)) < 150.0 ? 60.0 : -10.0;
  }));
  const double eye = 4.0;
  const std::vector<Way> ways = allWays({64, 128});
  for (const double away : {6000.0, 15000.0, 25000.0}) {
    SCOPED_TRACE(away);
    const Camera camera = looking({-away, 0.0, eye}, 0.0, 0.0, 1.5, {64, 200});
    const double pixel = radiansFromDegrees(1.5) / 200.0;
    // Its foreland's edge is 150 m nearer than its middle.
    const double near = away - 150.0;
    const double top = (60.0 - eye - seaDrop(near)) / near;
    const double horizon = -std::sqrt(2.0 * eye / earthMeanRadius);
    const double expected = std::max(0.0, top - horizon) / pixel;
    for (const Way& way : ways) {
      if (away != 15000.0 && way.name != "software") continue;
      SCOPED_TRACE(way.name);
      const Picture p = picture(*way.make(), water, camera);
      int rows = 0;
      for (int y = 0; y < 200; ++y) rows += p.at(32, y) == PixelClass::ground;
      // Nearer than the horizon its foot stands in the water below it.
      const double foot =
          near < horizonDistance(eye) ? (-eye - seaDrop(near)) / near - horizon : 0.0;
      EXPECT_NEAR(rows, expected - foot / pixel, 1.0);
    }
  }
}

TEST(TerrainPictures, WithoutTerrainOrOutOfViewNothingIsMadeOrDone) {
  const WaterSurface open = test::windSea(0.3, 8.0);
  const WaterSurface island = islandSea(test::windSea(0.3, 8.0));
  const Camera away = looking({-400.0, 0.0, 5.0}, 180.0, -3.0);
  for (const Way& way : allWays({32, 32})) {
    SCOPED_TRACE(way.name);
    const Picture without = picture(*way.make(), open, away);
    const Picture with = picture(*way.make(), island, away);
    for (const Picture* p : {&without, &with}) {
      EXPECT_EQ((*p)[Effect::terrain].state, EffectState::idle);
      EXPECT_EQ((*p)[Effect::terrain].memoryBytes, 0u);
      EXPECT_EQ((*p)[Effect::terrain].costMicroseconds, 0.0);
      for (const auto& pass : p->frame.stats.passesMs) EXPECT_NE(pass.first, "terrain");
    }
    EXPECT_EQ(with.frame.colour.rgb, without.frame.colour.rgb);
    EXPECT_EQ(with.frame.depth.metres, without.frame.depth.metres);
    EXPECT_EQ(without[Effect::terrain].reason, "the scene has no terrain");
    EXPECT_EQ(with[Effect::terrain].reason, "the terrain is out of the camera's view");
  }
}

/// Mean of a colour over the picture's middle.
double middleOf(const Picture& p, int colour) {
  const glm::ivec2 size = p.frame.depth.size;
  double sum = 0.0;
  for (int y = size.y / 2 - 6; y < size.y / 2 + 6; ++y) {
    for (int x = size.x / 2 - 6; x < size.x / 2 + 6; ++x) {
      sum += p.frame.colour.rgb[3 * p.index(x, y) + colour];
    }
  }
  return sum / 144.0;
}

WaterSurface overFlatBed(double depth, float reflectance) {
  TerrainLook look;
  look.sand = look.grass = look.rock = look.reef = glm::vec3(reflectance);
  WaterSurface water = test::stillSea();
  water.setTerrain(test::ground(
      {9, 9}, 20.0, [=](glm::dvec2) { return -depth; }, look));
  return water;
}

TEST(TerrainPictures, TheBedShowsThroughShallowWaterAndFadesWithDepthRedFirst) {
  const Camera camera = looking({1.0, 2.0, 20.0}, 0.0, -90.0, 40.0, {64, 48});
  for (const Way& way : allWays({32, 32})) {
    SCOPED_TRACE(way.name);
    const auto technique = way.make();
    double before[3] = {255.0, 255.0, 255.0};
    for (const double depth : {0.5, 2.0, 6.0, 15.0}) {
      const Picture light = picture(*technique, overFlatBed(depth, 0.6f), camera);
      const Picture dark = picture(*technique, overFlatBed(depth, 0.05f), camera);
      double shown[3];
      for (int c = 0; c < 3; ++c) {
        shown[c] = middleOf(light, c) - middleOf(dark, c);
        EXPECT_LE(shown[c], before[c] + 0.5);
        before[c] = shown[c];
      }
      if (depth == 2.0) {
        EXPECT_GT(shown[2], 30.0);
        EXPECT_LT(shown[0], shown[2]);
      }
      EXPECT_EQ(light.at(32, 24), PixelClass::water);
      EXPECT_EQ(light[Effect::refraction].state, EffectState::on);
    }
    EXPECT_LT(before[0], 1.0);  // no red comes back from 15 m
    const Picture deep = picture(*technique, overFlatBed(300.0, 0.6f), camera);
    EXPECT_EQ(deep[Effect::refraction].state, EffectState::idle);
  }
}

TEST(TerrainPictures, StraightDownTheBedAppearsAtItsDepthOverTheIndexOfRefraction) {
  const WaterSurface water = overFlatBed(4.0, 0.5f);
  EffectLedger effects;
  View view;
  view.water = &water;
  view.camera = looking({1.0, 2.0, 10.0}, 0.0, -90.0, 40.0, {32, 24});
  view.effects = &effects;
  Shown shown;
  shown.water = true;
  TerrainInView terrain;
  terrain.prepare(view, shown);
  TerrainInView::Triangles bed;
  terrain.fill(view.camera, TerrainSide::below, 0.05f, bed);
  Strip strip;
  strip.clear(0, 24, 32, false);
  bed.raster(strip);
  for (int y = 0; y < 24; ++y) {
    for (int x = 0; x < 32; ++x) {
      // One triangle reaches 113 m, where the sea has dropped by 1 mm.
      EXPECT_NEAR(1.0 / strip.inverse[y * strip.stride + x], 10.0 + 4.0 / seaWaterIndex, 2e-3);
    }
  }
}

TEST(TerrainPictures, CalmWaterMirrorsTheLand) {
  const WaterSurface water = islandSea(test::stillSea());
  // A hill of 18 m, 300 m away, above the middle of the picture, its mirror image below.
  const Camera camera = looking({-300.0, 0.0, 4.0}, 0.0, 0.0, 20.0, {120, 120});
  for (const Way& way : allWays({64, 64})) {
    SCOPED_TRACE(way.name);
    const auto technique = way.make();
    const Picture on = picture(*technique, water, camera, {}, 0.5);
    EffectSettings settings{};
    settings[static_cast<std::size_t>(Effect::reflection)] = EffectSetting::off;
    const Picture off = picture(*technique, water, camera, settings, 0.5);
    EXPECT_EQ(on[Effect::reflection].state, EffectState::on);
    const auto changed = [&](int y) {
      int sum = 0;
      for (int c = 0; c < 3; ++c) {
        sum += std::abs(on.frame.colour.rgb[3 * on.index(60, y) + c] -
                        off.frame.colour.rgb[3 * off.index(60, y) + c]);
      }
      return sum;
    };
    // 340 pixels a radian: the top 18 m up is mirrored (18 + 4)/300 below the level, row 85.
    EXPECT_GT(changed(72), 30);
    EXPECT_EQ(changed(20), 0);  // sky
  }
}

TEST(TerrainPictures, AllVariantsDrawTheSamePicture) {
  const WaterSurface water = islandSea(test::windSea(0.2, 8.0));
  const Camera camera = looking({-120.0, 20.0, 12.0}, -10.0, -8.0, 60.0, {160, 120});
  const Picture truth = picture(*makeSoftwareGrid({.grid = {256, 256}}), water, camera);
  const auto count = [&](PixelClass wanted) {
    return std::count(truth.frame.classes.begin(), truth.frame.classes.end(), wanted);
  };
  EXPECT_GT(count(PixelClass::ground), 2000);
  EXPECT_GT(count(PixelClass::water), 4000);
  for (const GridVariant variant :
       {GridVariant::cpuVertices, GridVariant::gpu, GridVariant::marched}) {
    SCOPED_TRACE(std::string(gridVariantName(variant)));
    const Picture p =
        picture(*makeProjectedGrid(test::sharedContext(), {.grid = {256, 256}, .variant = variant}),
                water, camera);
    double sum = 0.0;
    int pixels = 0, other = 0;
    for (std::size_t i = 0; i < truth.frame.classes.size(); ++i) {
      other += p.frame.classes[i] != truth.frame.classes[i];
      if (truth.frame.classes[i] != PixelClass::ground ||
          p.frame.classes[i] != PixelClass::ground) {
        continue;
      }
      ++pixels;
      for (int c = 0; c < 3; ++c) {
        const double off =
            double(p.frame.colour.rgb[3 * i + c]) - truth.frame.colour.rgb[3 * i + c];
        sum += off * off;
      }
    }
    // Texture filters of eight bits against floats, and sRGB's rounding: a level or two.
    EXPECT_LT(std::sqrt(sum / (3.0 * pixels)), 2.0);
    EXPECT_LE(other, 0.005 * 160 * 120);  // along the shore and the skyline
  }
}

TEST(TerrainPictures, PicturesAreTheSameBitsForAnyNumberOfThreads) {
  const WaterSurface water = islandSea(test::windSea(0.2, 8.0));
  const Camera camera = looking({-120.0, 20.0, 12.0}, -10.0, -8.0, 60.0, {160, 120});
  const auto drawn = [&](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return picture(*makeSoftwareGrid({.grid = {64, 64}}), water, camera);
  };
  const Picture one = drawn(1), four = drawn(4);
  EXPECT_EQ(one.frame.colour.rgb, four.frame.colour.rgb);
  EXPECT_EQ(one.frame.depth.metres, four.frame.depth.metres);
}

TEST(TerrainPicturesHard, CamerasOnInAndUnderTheGroundDrawFinitePictures) {
  const WaterSurface water = islandSea(test::windSea(0.2, 8.0));
  const double shore = 64.0;  // about: 0.2 m above the water
  const double ground = water.terrain()->heightAt({-shore + 4.0, 0.0});
  for (const Way& way : allWays({48, 48})) {
    SCOPED_TRACE(way.name);
    const auto technique = way.make();
    for (const double z : {ground + 0.01, ground - 1.0, -5.0, -11.9, -40.0}) {
      for (const double pitch : {-80.0, 0.0, 70.0}) {
        const Camera camera = looking({-shore + 4.0, 0.0, z}, 180.0, pitch, 60.0, {32, 24});
        const Picture p = picture(*technique, water, camera);
        for (std::size_t i = 0; i < p.frame.classes.size(); ++i) {
          const bool sky = p.frame.classes[i] == PixelClass::sky;
          ASSERT_TRUE(sky ? std::isinf(p.frame.depth.metres[i])
                          : std::isfinite(p.frame.depth.metres[i]));
        }
      }
    }
  }
}

TEST(TerrainPicturesHard, AllUnderWaterAllAboveItAndTheMapsEdgesAreDrawn) {
  std::vector<std::pair<std::string, std::unique_ptr<RenderTechnique>>> techniques;
  for (const Way& way : allWays({48, 48})) techniques.emplace_back(way.name, way.make());
  for (const double level : {-200.0, -1.0, 0.0, 40.0}) {
    SCOPED_TRACE(level);
    WaterSurface water = test::windSea(0.2, 8.0);
    water.setTerrain(test::ground({17, 9}, 5.0, [=](glm::dvec2) { return level; }));
    // Past its edge, from above and from the side.
    for (const Camera& camera : {looking({0.0, 0.0, 150.0}, 0.0, -90.0, 60.0, {80, 60}),
                                 looking({-90.0, 0.0, 30.0}, 0.0, -15.0, 60.0, {80, 60})}) {
      for (const auto& [name, technique] : techniques) {
        SCOPED_TRACE(name);
        const Picture p = picture(*technique, water, camera);
        const auto ground =
            std::count(p.frame.classes.begin(), p.frame.classes.end(), PixelClass::ground);
        if (level > 1.0) {
          EXPECT_GT(ground, 100);
        } else if (level < -0.5) {
          EXPECT_EQ(ground, 0);
        }
        EXPECT_GT(std::count(p.frame.classes.begin(), p.frame.classes.end(), PixelClass::water),
                  100);
      }
    }
  }
}

}  // namespace
}  // namespace seaway::render
