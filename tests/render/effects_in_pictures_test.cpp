#include <gtest/gtest.h>

#include <algorithm>

#include "tests/render/seas.h"

namespace seaway::render {
namespace {

Mesh tetrahedron() {
  const glm::vec3 a(2, 0, -1), b(-1, 2, -1), c(-1, -2, -1), d(0, 0, 2);
  Mesh mesh;
  mesh.parts.push_back({{a, c, b, a, b, d, b, c, d, c, a, d}, glm::vec3(0.7f, 0.1f, 0.1f)});
  mesh.boundingRadius = 2.3;
  return mesh;
}

struct Picture {
  Frame frame;
  std::vector<EffectReport> report;
  const EffectReport& operator[](Effect effect) const {
    return report[static_cast<std::size_t>(effect)];
  }
  bool ran(const std::string& pass) const {
    const auto& passes = frame.stats.passesMs;
    return std::any_of(passes.begin(), passes.end(),
                       [&](const auto& p) { return p.first == pass; });
  }
  long count(PixelClass wanted) const {
    return std::count(frame.classes.begin(), frame.classes.end(), wanted);
  }
};

Picture picture(const Camera& camera, const EffectSettings& settings = {},
                std::span<const SceneObject> objects = {}, const Light& light = {}) {
  const WaterSurface water = test::moderateSea();
  EffectLedger effects(settings);
  View view;
  view.water = &water;
  view.camera = camera;
  view.light = light;
  view.objects = objects;
  view.effects = &effects;
  Picture result;
  result.frame = makeProjectedGrid(test::sharedContext(), {.grid = {64, 64}})->draw(view);
  result.report = effects.report();
  return result;
}

EffectSettings without(Effect effect) {
  EffectSettings settings{};
  settings[static_cast<std::size_t>(effect)] = EffectSetting::off;
  return settings;
}

TEST(EffectsInPictures, WaterOutOfViewIsIdleAndCostsNothing) {
  const Picture p = picture(test::cameraAt({0, 0, 5}, 60.0));
  EXPECT_EQ(p[Effect::water].state, EffectState::idle);
  EXPECT_EQ(p[Effect::water].memoryBytes, 0u);
  EXPECT_EQ(p[Effect::water].costMicroseconds, 0.0);
  EXPECT_EQ(p.frame.stats.vertices, 0u);
  EXPECT_EQ(p.count(PixelClass::water), 0);
  EXPECT_FALSE(p.ran("water"));
}

TEST(EffectsInPictures, WaterSwitchedOffIsNeitherDrawnNorPaidFor) {
  const Picture p = picture(test::cameraAt({0, 0, 5}, -20.0), without(Effect::water));
  EXPECT_EQ(p[Effect::water].state, EffectState::off);
  EXPECT_EQ(p[Effect::water].memoryBytes, 0u);
  EXPECT_EQ(p[Effect::water].costMicroseconds, 0.0);
  EXPECT_EQ(p.count(PixelClass::water), 0);
}

TEST(EffectsInPictures, WaterInViewIsOnWithMemoryAndCost) {
  const Picture p = picture(test::cameraAt({0, 0, 5}, -20.0));
  EXPECT_EQ(p[Effect::water].state, EffectState::on);
  EXPECT_GT(p[Effect::water].memoryBytes, 64u * 64u * sizeof(float));
  EXPECT_GT(p[Effect::water].costMicroseconds, 0.0);
  EXPECT_GT(p.count(PixelClass::water), 5000);
}

TEST(EffectsInPictures, SkySwitchedOffHoldsNoMapAndDrawsNone) {
  const Picture p = picture(test::cameraAt({0, 0, 5}, 0.0), without(Effect::sky));
  EXPECT_EQ(p[Effect::sky].state, EffectState::off);
  EXPECT_EQ(p[Effect::sky].memoryBytes, 0u);
  EXPECT_EQ(p[Effect::sky].costMicroseconds, 0.0);
  EXPECT_FALSE(p.ran("sky"));
}

TEST(EffectsInPictures, SunBelowTheHorizonIsIdleAndTheNightIsDark) {
  Light night;
  night.sunElevation = -0.5;
  const Picture dark = picture(test::cameraAt({0, 0, 5}, 0.0), {}, {}, night);
  const Picture day = picture(test::cameraAt({0, 0, 5}, 0.0));
  EXPECT_EQ(dark[Effect::sun].state, EffectState::idle);
  EXPECT_EQ(day[Effect::sun].state, EffectState::on);
  const auto brightness = [](const Picture& p) {
    double sum = 0.0;
    for (const int value : p.frame.colour.rgb) sum += value;
    return sum;
  };
  EXPECT_LT(brightness(dark), 0.4 * brightness(day));
}

TEST(EffectsInPictures, SunSwitchedOffTakesAwayDiscAndGlitter) {
  Light light;
  light.sunElevation = 0.3;
  light.sunDirection = 0.4;  // where the camera looks
  const Camera camera = test::cameraAt({0, 0, 5}, 0.0, 0.0, 70.0);
  const Picture with = picture(camera, {}, {}, light);
  const Picture sunless = picture(camera, without(Effect::sun), {}, light);
  const auto white = [](const Picture& p) {
    int count = 0;
    for (std::size_t i = 0; i < p.frame.classes.size(); ++i) {
      const std::uint8_t* c = &p.frame.colour.rgb[3 * i];
      count += std::min({c[0], c[1], c[2]}) > 250;
    }
    return count;
  };
  EXPECT_EQ(sunless[Effect::sun].state, EffectState::off);
  EXPECT_GT(white(with), 100);
  EXPECT_EQ(white(sunless), 0);
}

TEST(EffectsInPictures, ObjectInViewIsDrawnAtItsPlaceAndDepth) {
  const Mesh mesh = tetrahedron();
  const Camera camera = test::cameraAt({0, 0, 8}, 0.0);
  SceneObject object{&mesh, camera.position + 20.0 * camera.forward(), attitude(1.0, 0.1, 0.0)};
  const Picture p = picture(camera, {}, {&object, 1});
  EXPECT_EQ(p[Effect::vesselMeshes].state, EffectState::on);
  const std::size_t centre = std::size_t{45} * 160 + 80;
  EXPECT_EQ(p.frame.classes[centre], PixelClass::object);
  EXPECT_NEAR(p.frame.depth.metres[centre], 20.0, 2.5);  // the mesh's radius
  // About 4 m at 20 m: 17 % of a 60° view's height.
  EXPECT_GT(p.count(PixelClass::object), 60);
  EXPECT_LT(p.count(PixelClass::object), 400);
}

TEST(EffectsInPictures, ObjectBehindTheCameraIsIdleAndHoldsNoMemory) {
  const Mesh mesh = tetrahedron();
  const Camera camera = test::cameraAt({0, 0, 8}, 0.0);
  SceneObject object{&mesh, camera.position - 20.0 * camera.forward(), {1, 0, 0, 0}};
  const Picture p = picture(camera, {}, {&object, 1});
  EXPECT_EQ(p[Effect::vesselMeshes].state, EffectState::idle);
  EXPECT_EQ(p[Effect::vesselMeshes].memoryBytes, 0u);
  EXPECT_EQ(p[Effect::vesselMeshes].costMicroseconds, 0.0);
  EXPECT_EQ(p.count(PixelClass::object), 0);
}

TEST(EffectsInPictures, WavesHideWhatLiesBehindAndBelowThem) {
  const Mesh mesh = tetrahedron();
  const Camera camera = test::cameraAt({0, 0, 8}, -30.0);
  SceneObject sunk{&mesh, camera.position + 40.0 * camera.forward(), {1, 0, 0, 0}};
  EXPECT_LT(sunk.position.z, -8.0);
  EXPECT_EQ(picture(camera, {}, {&sunk, 1}).count(PixelClass::object), 0);
}

}  // namespace
}  // namespace seaway::render
