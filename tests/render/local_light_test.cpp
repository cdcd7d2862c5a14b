#include "render/local_light.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <limits>
#include <memory>

#include "render/fresnel.h"
#include "tests/render/stage.h"

// Scene objects by way of the water: mirrored in it, and seen through it.
namespace seaway::render {
namespace {

/// test::Stage in clear water, with a look at the pictures alone.
struct Stage : test::Stage {
  Stage() { light.turbidity = 0.0; }
  /// The pictures alone.
  LocalLight pictures() const {
    EffectLedger effects(settings);
    const View seen = view(effects);
    Lighting lighting;
    lighting.waterIsOn = true;
    lighting.sunDirection = sunDirectionOf(seen);
    lighting.sunIsOn = true;
    LocalLight local;
    local.fill(seen, {.water = true, .objects = true}, {shadingConstants(seen, lighting)}, {});
    return local;
  }
};

/// How much brighter a pixel of water is in `a` than in `b`, or darker, in 255ths of all channels.
int change(const Frame& a, const Frame& b, int x, int y) {
  const std::size_t i = static_cast<std::size_t>(y) * a.colour.size.x + x;
  if (a.classes[i] != PixelClass::water) return 0;
  int sum = 0;
  for (std::size_t c = 3 * i; c < 3 * i + 3; ++c) {
    sum += std::abs(int{a.colour.rgb[c]} - int{b.colour.rgb[c]});
  }
  return sum;
}

Stage pole(const Mesh& mesh) {
  Stage stage;
  stage.camera = test::cameraAt({0, 0, 4.0}, -8.0, 0.0, 45.0, {400, 300});
  stage.camera.worldFromCamera = attitude(0.0, -0.14, 0.0);
  stage.objects = {{&mesh, {30.0, 1.0, 0.0}, {1, 0, 0, 0}}};
  return stage;
}

TEST(LocalLight, APoleIsMirroredWhereTheMirroredCameraSeesIt) {
  const Mesh mesh = test::boxMesh({-0.3, -0.3, -2.0}, {0.3, 0.3, 3.0}, glm::vec3(0.9f));
  Stage stage = pole(mesh);
  stage.settings[static_cast<std::size_t>(Effect::refraction)] = EffectSetting::off;
  Stage without = stage;
  without.settings[static_cast<std::size_t>(Effect::reflection)] = EffectSetting::off;
  for (const bool inGl : {false, true}) {
    const auto technique = inGl ? makeProjectedGrid(test::sharedContext(), {.grid = {128, 256}})
                                : makeSoftwareGrid({.grid = {128, 256}});
    const Frame with = stage.draw(*technique), bare = without.draw(*technique);
    const auto at = [&](double x, double y, double z) {
      return test::pixelOf(stage.camera, {x, y, z});
    };
    // By the mirrored corners; its nearer side hides the water between it and the farther one.
    const double top = at(29.7, 1.0, 0.0).y, bottom = at(29.7, 1.0, -3.0).y;
    const double left = at(29.7, 1.3, -1.5).x, right = at(29.7, 0.7, -1.5).x;
    const int middle = static_cast<int>(0.5 * (left + right));
    const int centre = static_cast<int>(0.5 * (top + bottom));
    const int whole = change(with, bare, middle, centre);
    ASSERT_GT(whole, 30) << inGl;
    // Cox and Munk's slick of a windless sea is rough by 0.04 along an axis: up and down the edges
    // are as steep as its facets, of which half are beyond; sideways they are sharp.
    const auto shows = [&](int x, int y) { return change(with, bare, x, y) > 0.4 * whole; };
    int first = 0, last = 299;
    while (first < 300 && !shows(middle, first)) ++first;
    while (last > 0 && !shows(middle, last)) --last;
    EXPECT_NEAR(first, top, 1.0) << inGl;
    EXPECT_NEAR(last, bottom, 1.0) << inGl;
    int from = middle, to = middle;
    while (from > 0 && shows(from - 1, centre)) --from;
    while (to < 399 && shows(to + 1, centre)) ++to;
    EXPECT_NEAR(from, left, 1.0) << inGl;
    EXPECT_NEAR(to, right, 1.0) << inGl;
  }
}

TEST(LocalLight, NothingBelowTheWaterLeaksIntoTheMirror) {
  const Mesh mesh = test::boxMesh({-1.0, -1.0, -3.0}, {1.0, 1.0, -0.2}, glm::vec3(0.9f));
  Stage stage = pole(mesh);
  EXPECT_TRUE(stage.pictures().mirrored().empty());
  EXPECT_FALSE(stage.pictures().below().empty());
  // A box that stands half in the water: whatever is mirrored lies below the plane.
  const Mesh half = test::boxMesh({-1.0, -1.0, -3.0}, {1.0, 1.0, 2.0}, glm::vec3(0.9f));
  stage = pole(half);
  const LocalLight light = stage.pictures();
  const auto heights = [&](const LocalImage& image) {
    double least = 1e9, most = -1e9;
    for (int y = 0; y < image.size.y; ++y) {
      for (int x = 0; x < image.size.x; ++x) {
        const float nearness = image.nearness[static_cast<std::size_t>(y) * image.size.x + x];
        if (nearness == 0.0f) continue;
        const glm::dvec3 ray = stage.camera.rayThrough(glm::dvec2(image.least + glm::ivec2(x, y)));
        const double range = 1.0 / (nearness * glm::dot(ray, stage.camera.forward()));
        least = std::min(least, stage.camera.position.z + range * ray.z);
        most = std::max(most, stage.camera.position.z + range * ray.z);
      }
    }
    return glm::dvec2(least, most);
  };
  // A pixel at 30 m is 0.08 m high: rims are those of its centre; and the sea drops 0.07 mm.
  const glm::dvec2 mirrored = heights(light.mirrored());
  EXPECT_LE(mirrored.y, 1e-3);
  EXPECT_NEAR(mirrored.x, -2.0, 0.1);
  const glm::dvec2 below = heights(light.below());
  EXPECT_LE(below.y, 1e-3);
  EXPECT_NEAR(below.x, -3.0 / seaWaterIndex, 0.1);
}

TEST(LocalLight, SeenStraightDownThingsLieAtTheirDepthOverTheIndex) {
  const Mesh mesh = test::boxMesh({-2.0, -2.0, -1.0}, {2.0, 2.0, 0.0}, glm::vec3(0.8f));
  Stage stage;
  stage.camera = test::cameraAt({0, 0, 5.0}, -90.0, 0.0, 30.0, {101, 101});
  stage.objects = {{&mesh, {0.0, 0.0, -4.0}, {1, 0, 0, 0}}};
  const LocalImage below = stage.pictures().below();
  const glm::ivec2 middle = glm::ivec2(50, 50) - below.least;
  const float nearness =
      below.nearness[static_cast<std::size_t>(middle.y) * below.size.x + middle.x];
  EXPECT_NEAR(1.0 / nearness, 5.0 + 4.0 / seaWaterIndex, 1e-5 * 8.0);  // floats of 8 m
}

TEST(LocalLight, RedIsGoneAfterFourAndAHalfMetresOfClearWater) {
  EffectLedger effects;
  Stage stage;
  stage.camera = test::cameraAt({0, 0, 5.0}, -30.0);
  const View view = stage.view(effects);
  const ShadingConstants c = shadingConstants(view, {});
  EXPECT_NEAR(std::exp(-c.waterExtinction.r * 4.5), 0.05, 0.0005);  // e⁻³ is 0.0498
  EXPECT_NEAR(std::exp(-c.waterExtinction.g * 75.0), 0.05, 0.0005);
  EXPECT_NEAR(std::exp(-c.waterExtinction.b * 300.0), 0.05, 0.0005);
}

/// Mean colour of the picture's middle, [0, 255].
glm::dvec3 middleColour(const Frame& frame) {
  glm::dvec3 sum(0.0);
  const glm::ivec2 size = frame.colour.size;
  for (int y = size.y / 2 - 5; y < size.y / 2 + 5; ++y) {
    for (int x = size.x / 2 - 5; x < size.x / 2 + 5; ++x) {
      for (int c = 0; c < 3; ++c) {
        sum[c] += frame.colour.rgb[3 * (static_cast<std::size_t>(y) * size.x + x) + c] / 100.0;
      }
    }
  }
  return sum;
}

TEST(LocalLight, WhiteThingsTurnGreenBlueAndDarkAsTheySink) {
  const Mesh mesh = test::boxMesh({-3.0, -3.0, -0.5}, {3.0, 3.0, 0.0}, glm::vec3(0.8f));
  Stage stage;
  stage.camera = test::cameraAt({0, 0, 5.0}, -90.0, 0.0, 30.0, {101, 101});
  const auto technique = makeSoftwareGrid({.grid = {64, 64}});
  const glm::dvec3 water = middleColour(stage.draw(*technique));
  glm::dvec3 before(256.0);
  for (const double depth : {0.2, 2.0, 8.0}) {
    stage.objects = {{&mesh, {0.0, 0.0, -depth}, {1, 0, 0, 0}}};
    const glm::dvec3 colour = middleColour(stage.draw(*technique));
    std::printf("%.1f m: %.0f %.0f %.0f\n", depth, colour.r, colour.g, colour.b);
    EXPECT_LT(colour.r, before.r);
    EXPECT_GT(colour.g, water.g);
    before = colour;
  }
  EXPECT_GT(before.g - water.g, 4.0 * (before.r - water.r));  // hardly any red is left at 8 m
  stage.light.turbidity = 2.0;
  const glm::dvec3 murky = middleColour(stage.draw(*technique));
  EXPECT_LT(glm::length(murky - water), 2.0);  // two of 255: nothing of it is seen
}

TEST(LocalLight, NothingIsHeldOrDrawnUnlessCalledFor) {
  const Mesh mesh = test::boxMesh({-0.3, -0.3, -2.0}, {0.3, 0.3, 3.0}, glm::vec3(0.9f));
  const auto states = [&](Stage stage) {
    EffectLedger effects(stage.settings);
    const auto technique = makeSoftwareGrid({.grid = {64, 64}});
    technique->draw(stage.view(effects));
    const auto report = effects.report();
    for (const Effect effect : {Effect::reflection, Effect::refraction}) {
      const EffectReport& r = report[static_cast<std::size_t>(effect)];
      EXPECT_EQ(r.state == EffectState::on, r.memoryBytes > 0) << r.reason;
    }
    return std::pair(report[static_cast<std::size_t>(Effect::reflection)].state,
                     report[static_cast<std::size_t>(Effect::refraction)].state);
  };
  using enum EffectState;
  EXPECT_EQ(states(pole(mesh)), std::pair(on, on));
  Stage empty = pole(mesh);
  empty.objects.clear();
  EXPECT_EQ(states(empty), std::pair(idle, idle));
  Stage away = pole(mesh);
  away.camera.worldFromCamera = attitude(3.1, -0.14, 0.0);
  EXPECT_EQ(states(away), std::pair(idle, idle));
  Stage under = pole(mesh);
  under.camera.position.z = -1.0;
  EXPECT_EQ(states(under), std::pair(idle, idle));
  Stage far = pole(mesh);
  far.objects[0].position.x = 900.0;
  EXPECT_EQ(states(far), std::pair(on, idle));
  Stage flying = pole(mesh);
  flying.objects[0].position.z = 2.5;
  EXPECT_EQ(states(flying), std::pair(on, idle));
  Stage switchedOff = pole(mesh);
  switchedOff.settings[static_cast<std::size_t>(Effect::reflection)] = EffectSetting::off;
  EXPECT_EQ(states(switchedOff).first, EffectState::off);
}

TEST(LocalLightHard, CamerasInTheWaterPlaneAndThingsAshoreDrawNumbers) {
  const Mesh mesh = test::boxMesh({-2.0, -1.0, -1.0}, {2.0, 1.0, 2.0}, glm::vec3(0.6f));
  const auto technique = makeSoftwareGrid({.grid = {64, 128}});
  for (const double height : {0.0, 1e-9, 1e-3, 4.0}) {
    Stage stage = pole(mesh);
    stage.camera.position.z = height;
    stage.camera.worldFromCamera = attitude(0.0, 0.0, 0.0);
    for (const double away : {0.5, 3.0, 30.0}) {  // inside of it, next to it, off
      stage.objects[0].position = {away, 0.2, 0.3};
      const Frame frame = stage.draw(*technique);
      EXPECT_EQ(std::count_if(frame.depth.metres.begin(), frame.depth.metres.end(),
                              [](float d) { return std::isnan(d); }),
                0);
      for (const LocalImage& image : {stage.pictures().mirrored(), stage.pictures().below()}) {
        for (std::size_t i = 0; i < image.light.size(); ++i) {
          ASSERT_TRUE(std::isfinite(image.nearness[i] + image.radiance(i).x));
          ASSERT_EQ(image.light[i] == 0, image.nearness[i] == 0.0f);
        }
      }
    }
  }
  Stage ashore = pole(mesh);
  const std::vector<OutlinePolygon> pond{{{{{-9, -9}, {9, -9}, {9, 9}, {-9, 9}}}}};
  ashore.water.setOutline(std::make_shared<const WaterOutline>(pond));
  EXPECT_TRUE(ashore.pictures().mirrored().empty());
}

}  // namespace
}  // namespace seaway::render
