#include <gtest/gtest.h>

#include <cstdio>

#include "render/fresnel.h"
#include "render/shadow_maps.h"
#include "surface/constants.h"
#include "tests/render/gl_census.h"
#include "tests/render/stage.h"

// Shadows of the sun: where they fall, that nothing shades itself, and what they cost.
namespace seaway::render {
namespace {

using test::Stage;

/// What the shading text makes of the maps, place by place, in double: shadows.glsl.h without the
/// spline.
class Reading {
 public:
  Reading(const Stage& stage) {
    EffectLedger effects(stage.settings);
    const View view = stage.view(effects);
    Lighting lighting;
    lighting.sunIsOn = true;
    lighting.sunDirection = sunDirectionOf(view);
    maps.fill(view, {.water = stage.hasWater, .objects = true}, lighting);
    constants = shadingConstants(view, lighting);
    maps.setConstants(constants);
    report = effects.report()[static_cast<std::size_t>(Effect::shadows)];
  }
  ShadowMaps maps;
  ShadingConstants constants;
  EffectReport report;
};

/// A floor 40 m wide at 0 m with a pole 0.5 m thick and 4 m high on it, seen from straight above.
struct PoleOnFloor {
  Mesh floor = test::boxMesh({-20, -20, -0.5}, {20, 20, 0}, glm::vec3(0.5f));
  Mesh pole = test::boxMesh({-0.25f, -0.25f, 0}, {0.25f, 0.25f, 4}, glm::vec3(0.5f));
  Stage stage;
  PoleOnFloor(double elevation_deg) {
    stage.hasWater = false;
    stage.camera = test::cameraAt({0, 0, 30}, -90.0, 0.0, 50.0, {300, 300});
    stage.camera.worldFromCamera = attitude(0.0, -0.5 * pi, 0.0);
    stage.light.sunElevation = radiansFromDegrees(elevation_deg);
    stage.light.sunDirection = pi;  // in the west: shadows fall eastwards, up in the picture
    stage.objects = {{&floor, {0, 0, 0}, {1, 0, 0, 0}}, {&pole, {0, 0, 0}, {1, 0, 0, 0}}};
  }
};

TEST(Shadows, APolesShadowOnAFloorLiesWhereGeometryPutsIt) {
  PoleOnFloor scene(40.0);
  const double length = 4.0 / std::tan(radiansFromDegrees(40.0));
  const Camera& camera = scene.stage.camera;
  const double texel = Reading(scene.stage).constants.shadowTexel[0];
  // 1.5 texels of the map in the sun's view, and a pixel of the picture, 0.093 m.
  const double pixel = 2.0 * std::tan(radiansFromDegrees(25.0)) * 30.0 / 300;
  const double across = 1.5 * texel + pixel;
  const double along = (1.5 + 2.13) * texel / std::sin(radiansFromDegrees(40.0)) + pixel;
  std::printf("texel %.4f m: within %.3f m across, %.3f m along\n", texel, across, along);
  for (const auto& way : test::everyWay({32, 32})) {
    const Frame with = scene.stage.draw(*way.technique);
    const Frame bare = scene.stage.without(Effect::shadows).draw(*way.technique);
    const auto isDark = [&](double x, double y) {
      const glm::ivec2 p(glm::round(test::pixelOf(camera, {x, y, 0.0})));
      return test::brightness(with, p.x, p.y) < 0.8 * test::brightness(bare, p.x, p.y);
    };
    for (double x = 0.6; x < length - along; x += 0.1) {
      EXPECT_TRUE(isDark(x, 0.25 - across)) << way.name << ' ' << x;
      EXPECT_TRUE(isDark(x, -0.25 + across)) << way.name << ' ' << x;
      EXPECT_FALSE(isDark(x, 0.25 + across)) << way.name << ' ' << x;
      EXPECT_FALSE(isDark(x, -0.25 - across)) << way.name << ' ' << x;
    }
    EXPECT_FALSE(isDark(length + 0.25 + along, 0.0)) << way.name;
    EXPECT_FALSE(isDark(-0.6, 0.0)) << way.name;
  }
}

TEST(Shadows, NoLitFaceShadesItselfAtAnySun) {
  for (const double elevation : {0.1, 1.0, 5.0, 20.0, 45.0, 70.0, 90.0}) {
    PoleOnFloor scene(elevation);
    scene.stage.objects.pop_back();
    const auto technique = makeSoftwareGrid({.grid = {16, 16}});
    for (const double heading : {0.0, 0.37, 1.1}) {
      scene.stage.light.sunDirection = heading;
      EXPECT_EQ(scene.stage.draw(*technique).colour.rgb,
                scene.stage.without(Effect::shadows).draw(*technique).colour.rgb)
          << elevation << ' ' << heading;
    }
  }
}

TEST(Shadows, OnWaterOneDimsWhatComesUpAndNotTheMirroredSky) {
  const Mesh wall = test::boxMesh({-0.2f, -6, -1}, {0.2f, 6, 5}, glm::vec3(0.3f));
  Stage stage;
  stage.camera = test::cameraAt({12, 0, 25}, -90.0, 0.0, 40.0, {120, 120});
  stage.camera.worldFromCamera = attitude(0.0, -0.5 * pi, 0.0);
  stage.light.sunElevation = radiansFromDegrees(35.0);
  stage.light.sunDirection = pi;
  stage.objects = {{&wall, {0, 0, 0}, {1, 0, 0, 0}}};
  const double length = 5.0 / std::tan(stage.light.sunElevation);
  for (const auto& way : test::everyWay({64, 64})) {
    const Frame with = stage.draw(*way.technique);
    const Frame bare = stage.without(Effect::shadows).draw(*way.technique);
    const auto at = [&](const Frame& frame, double x, double y) {
      const glm::ivec2 p(glm::round(test::pixelOf(stage.camera, {x, y, 0.0})));
      return test::brightness(frame, p.x, p.y);
    };
    EXPECT_LT(at(with, 0.7 * length, 0.0), at(bare, 0.7 * length, 0.0) - 5) << way.name;
    EXPECT_GT(at(with, 0.7 * length, 0.0), 0.3 * at(bare, 0.7 * length, 0.0)) << way.name;
    EXPECT_EQ(at(with, length + 1.0, 0.0), at(bare, length + 1.0, 0.0)) << way.name;
    EXPECT_EQ(at(with, 0.7 * length, 7.0), at(bare, 0.7 * length, 7.0)) << way.name;
  }
}

TEST(Shadows, UnderWaterTheyBendAsTheLightDoes) {
  // A pole's top at 4 m and a plate 3 m under water: the shadow of the top falls there.
  const Mesh plate = test::boxMesh({-15, -15, -0.2f}, {15, 15, 0}, glm::vec3(0.8f));
  const Mesh post = test::boxMesh({-0.3f, -0.3f, 3}, {0.3f, 0.3f, 4}, glm::vec3(0.5f));
  Stage stage;
  stage.camera = test::cameraAt({0, 0, 20}, -90.0, 0.0, 60.0, {200, 200});
  stage.light.sunElevation = radiansFromDegrees(45.0);
  stage.light.sunDirection = pi;
  stage.objects = {{&plate, {0, 0, -3}, {1, 0, 0, 0}}, {&post, {0, 0, 0}, {1, 0, 0, 0}}};
  const Reading reading(stage);
  const ShadingConstants& c = reading.constants;
  ASSERT_GT(c.shadowCount, 0);
  // The middle of the post's shadow: straight to the water, then at Snell's angle.
  const double sine = std::cos(radiansFromDegrees(45.0)) / seaWaterIndex;
  const double wanted = 3.5 + 3.0 * sine / std::sqrt(1.0 - sine * sine);
  const auto isShaded = [&](double x) {
    const glm::dvec3 place(x, 0.0, -3.0 - 20.0);
    const glm::dvec3 straight = place + glm::dvec3(c.shadowBend) * 3.0;
    const glm::ivec2 at(glm::round(glm::dvec2(glm::dot(straight, glm::dvec3(c.shadowRight)),
                                              glm::dot(straight, glm::dvec3(c.shadowUp))) /
                                       double{c.shadowTexel[0]} -
                                   glm::dvec2(c.shadowLeast[0])));
    const double height = glm::dot(straight, glm::dvec3(c.sunDirection)) - c.shadowBase;
    const std::size_t texel =
        static_cast<std::size_t>(at.y + c.shadowRow[0]) * reading.maps.size().x + at.x;
    return reading.maps.texels()[texel] > height + 0.1;
  };
  // The post is 1 m high and 0.6 m thick: its shadow is 1.6 m long there.
  EXPECT_TRUE(isShaded(wanted));
  EXPECT_TRUE(isShaded(wanted - 0.75));
  EXPECT_TRUE(isShaded(wanted + 0.75));
  EXPECT_FALSE(isShaded(wanted - 0.85));
  EXPECT_FALSE(isShaded(wanted + 0.85));
}

TEST(Shadows, WhereNothingCastsOneTheyAreIdleAndCostNothing) {
  using enum EffectState;
  const Mesh mesh = test::boxMesh({-1, -1, -1}, {1, 1, 2}, glm::vec3(0.5f));
  Stage near;
  near.camera = test::cameraAt({0, 0, 4}, -8.0, 0.0, 45.0, {64, 48});
  near.camera.worldFromCamera = attitude(0.0, -0.14, 0.0);
  near.objects = {{&mesh, {30, 1, 0}, {1, 0, 0, 0}}};
  Stage empty = near, behind = near, night = near, unasked = near.without(Effect::shadows);
  empty.objects.clear();
  behind.objects[0].position.x = -60.0;
  behind.light.sunDirection = 0.0;  // ahead: the shadow falls backwards
  night.light.sunElevation = -0.05;
  Stage cast = behind;
  cast.light.sunDirection = pi;  // behind: a long shadow falls into the view
  cast.light.sunElevation = 0.03;
  const struct {
    const Stage& stage;
    EffectState state;
  } cases[] = {
      {near, on}, {empty, idle}, {behind, idle}, {night, idle}, {unasked, EffectState::off},
      {cast, on}};
  for (const bool inGl : {false, true}) {
    int number = 0;
    for (const auto& c : cases) {
      const auto technique = inGl ? makeProjectedGrid(test::sharedContext(), {.grid = {32, 32}})
                                  : makeSoftwareGrid({.grid = {32, 32}});
      const EffectReport report = c.stage.report(*technique, Effect::shadows);
      EXPECT_EQ(report.state, c.state) << number << ": " << report.reason;
      EXPECT_EQ(report.memoryBytes > 0, c.state == on) << number;
      EXPECT_EQ(report.costMicroseconds > 0.0, c.state == on) << number;
      if (c.state == idle) {
        EXPECT_EQ(c.stage.draw(*technique).colour.rgb,
                  c.stage.without(Effect::shadows).draw(*technique).colour.rgb)
            << number;
      }
      ++number;
    }
  }
}

TEST(Shadows, WhereIdleNoTextureIsMade) {
  const Mesh mesh = test::boxMesh({-1, -1, -1}, {1, 1, 2}, glm::vec3(0.5f));
  Stage stage;
  stage.camera = test::cameraAt({0, 0, 4}, -8.0, 0.0, 45.0, {64, 48});
  stage.camera.worldFromCamera = attitude(0.0, -0.14, 0.0);
  stage.objects = {{&mesh, {30, 1, 0}, {1, 0, 0, 0}}};
  stage.light.sunElevation = -0.05;
  test::sharedContext().makeCurrent();
  const auto technique = makeProjectedGrid(test::sharedContext(), {.grid = {32, 32}});
  stage.draw(*technique);
  const test::GlCensus census;
  for (int i = 0; i < 3; ++i) stage.draw(*technique);
  EXPECT_EQ(test::GlCensus::made(), 0);
  stage.light.sunElevation = 0.6;
  stage.draw(*technique);
  EXPECT_EQ(test::GlCensus::alive()["texture"], 1);
}

TEST(ShadowsHard, ManyThingsNearAndFarAndSlantsOfTheSunDrawNumbers) {
  const Mesh mesh = test::boxMesh({-0.5f, -0.5f, -1}, {0.5f, 0.5f, 2}, glm::vec3(0.5f));
  Mesh bad;  // without area, and of one point
  bad.parts.push_back({{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, {}});
  bad.boundingRadius = 2.0;
  Stage stage;
  stage.camera = test::cameraAt({0, 0, 6}, -8.0, 0.0, 60.0, {96, 64});
  stage.camera.worldFromCamera = attitude(0.0, -0.1, 0.0);
  for (int i = 0; i < 1000; ++i) {
    const double away = 10.0 * std::pow(3000.0, i / 999.0);  // 10 m to 30 km
    stage.objects.push_back({i % 10 ? &mesh : &bad,
                             {away, away * 0.5 * std::sin(2.4 * i), 0.0},
                             {1, 0, 0, 0},
                             0,
                             ObjectKind::scenery});
  }
  const auto technique = makeSoftwareGrid({.grid = {64, 64}});
  for (const double elevation : {90.0, 30.0, 0.1, 1e-6, 0.0, -0.1, -90.0}) {
    stage.light.sunElevation = radiansFromDegrees(elevation);
    const Frame frame = stage.draw(*technique);
    for (const float d : frame.depth.metres) ASSERT_GT(d, 0.0f);
    const Reading reading(stage);
    EXPECT_LE(reading.constants.shadowCount, ShadowMaps::most);
    for (const float t : reading.maps.texels()) ASSERT_TRUE(std::isfinite(t) && t >= 0.0f);
    EXPECT_EQ(reading.report.state == EffectState::on, elevation > 0.01) << elevation;
  }
}

TEST(ShadowsHard, AtThirtyKilometresFromTheCameraAFaceDoesNotShadeItself) {
  const Mesh mesh = test::boxMesh({-30, -30, -10}, {30, 30, 40}, glm::vec3(0.5f));
  Stage stage;
  stage.hasWater = false;
  stage.camera = test::cameraAt({0, 0, 400}, 0.0, 0.0, 0.3, {96, 64});
  stage.camera.worldFromCamera = attitude(0.0, -0.0145, 0.0);
  stage.objects = {{&mesh, {30e3, 0, 0}, {1, 0, 0, 0}}};
  stage.light.sunDirection = 2.5;
  const auto technique = makeSoftwareGrid({.grid = {16, 16}});
  const Frame with = stage.draw(*technique);
  EXPECT_GT(std::count(with.classes.begin(), with.classes.end(), PixelClass::object), 100);
  EXPECT_EQ(with.colour.rgb, stage.without(Effect::shadows).draw(*technique).colour.rgb);
}

}  // namespace
}  // namespace seaway::render
