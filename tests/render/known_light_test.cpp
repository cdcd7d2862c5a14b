#include <gtest/gtest.h>

#include <cstdio>
#include <glm/geometric.hpp>

#include "tests/render/seas.h"

// What sailors know of light on water, in drawn pictures.
namespace seaway::render {
namespace {

struct Scene {
  WaterSurface water = test::groupSea(0.5, 3.5);
  Camera camera = test::cameraAt({0, 0, 6.0}, -8.0, 0.0, 60.0, {240, 160});
  Light light;
  EffectSettings settings{};

  Scene() { light.sunDirection = 3.5; }
  Frame draw() const {
    EffectLedger effects(settings);
    View view;
    view.water = &water;
    view.time = 3.0;
    view.camera = camera;
    view.light = light;
    view.effects = &effects;
    return makeSoftwareGrid({.grid = {128, 192}})->draw(view);
  }
  Scene& without(Effect effect) {
    settings[static_cast<std::size_t>(effect)] = EffectSetting::off;
    return *this;
  }
};

double linear(std::uint8_t byte) {
  const double s = byte / 255.0;
  return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}

/// Mean displayed luminance of a row's pixels of one class; NaN where there is none.
double rowLuminance(const Frame& frame, int row, PixelClass wanted) {
  double sum = 0.0;
  int count = 0;
  for (int x = 0; x < frame.colour.size.x; ++x) {
    const std::size_t i = static_cast<std::size_t>(row) * frame.colour.size.x + x;
    if (frame.classes[i] != wanted) continue;
    const std::uint8_t* c = &frame.colour.rgb[3 * i];
    sum += 0.2126 * linear(c[0]) + 0.7152 * linear(c[1]) + 0.0722 * linear(c[2]);
    ++count;
  }
  return sum / count;
}

/// How bright the water just below the horizon is beside the sky just above it.
double waterOverSkyAtHorizon(const WaterSurface& water, double wind) {
  Scene scene;
  scene.water = water;
  scene.light.windSpeed = wind;
  // Haze would make any sea's last mile as bright as the sky.
  scene.without(Effect::haze).without(Effect::foam).without(Effect::sun);
  const Frame frame = scene.draw();
  int horizon = 0;
  while (frame.classes[static_cast<std::size_t>(horizon) * 240 + 120] == PixelClass::sky) ++horizon;
  return rowLuminance(frame, horizon + 3, PixelClass::water) /
         rowLuminance(frame, horizon - 3, PixelClass::sky);
}

TEST(KnownLight, NearTheHorizonOnlyCalmWaterIsAMirror) {
  const double calm = waterOverSkyAtHorizon(test::stillSea(), 0.0);
  const double breeze = waterOverSkyAtHorizon(test::groupSea(0.5, 3.5), 5.0);
  const double gale = waterOverSkyAtHorizon(test::groupSea(4.0, 8.0), 16.0);
  std::printf("water over sky at the horizon: calm %.2f, breeze %.2f, gale %.2f\n", calm, breeze,
              gale);
  // A degree below the horizon even Cox and Munk's slick of a windless sea (slopes of 2.2°) mirrors
  // what stands a little higher, where the sky is darker.
  EXPECT_GT(calm, 0.65);
  EXPECT_LT(breeze, 0.6 * calm);
  EXPECT_LT(gale, breeze);
}

TEST(KnownLight, StraightDownWaterIsDark) {
  Scene scene;
  scene.camera = test::cameraAt({0, 0, 30.0}, -90.0, 0.0, 20.0, {100, 100});
  scene.without(Effect::foam);
  const Frame down = scene.draw();
  scene.camera = test::cameraAt({0, 0, 30.0}, -4.0, 0.0, 20.0, {100, 100});
  const Frame level = scene.draw();
  const double below = rowLuminance(down, 50, PixelClass::water);
  const double far = rowLuminance(level, 40, PixelClass::water);
  const double sky = rowLuminance(level, 2, PixelClass::sky);
  std::printf("straight down %.3f, far %.3f, sky %.3f\n", below, far, sky);
  // 2 % of the sky is mirrored there and 3 % come back from below (of what water reflects green).
  EXPECT_LT(below, 0.15 * sky);
  EXPECT_LT(below, 0.5 * far);
}

/// Standard deviation of azimuth of the light that the sun adds to the water, rad.
double glitterWidth(double sunElevation_deg) {
  Scene scene;
  scene.light.sunElevation = radiansFromDegrees(sunElevation_deg);
  scene.light.sunDirection = 0.4;  // where the camera looks
  scene.camera = test::cameraAt({0, 0, 12.0}, -14.0, 0.0, 80.0, {320, 160});
  scene.without(Effect::foam).without(Effect::haze);
  const Frame with = scene.draw();
  scene.without(Effect::sun);
  const Frame bare = scene.draw();
  double sum = 0.0, squares = 0.0;
  for (int y = 0; y < 160; ++y) {
    for (int x = 0; x < 320; ++x) {
      const std::size_t i = static_cast<std::size_t>(y) * 320 + x;
      if (with.classes[i] != PixelClass::water) continue;
      const double added =
          std::max(linear(with.colour.rgb[3 * i + 1]) - linear(bare.colour.rgb[3 * i + 1]), 0.0);
      const glm::dvec3 ray = scene.camera.rayThrough({x, y});
      const double off = std::remainder(std::atan2(ray.y, ray.x) - 0.4, 2.0 * pi);
      sum += added;
      squares += added * off * off;
    }
  }
  return std::sqrt(squares / sum);
}

TEST(KnownLight, TheGlitterPathNarrowsTowardsALowSun) {
  const double high = glitterWidth(45.0), middle = glitterWidth(20.0), low = glitterWidth(6.0);
  std::printf("glitter is %.1f, %.1f and %.1f degrees wide at 45, 20 and 6 degrees\n",
              high * 180 / pi, middle * 180 / pi, low * 180 / pi);
  EXPECT_LT(middle, 0.85 * high);
  EXPECT_LT(low, 0.85 * middle);
}

}  // namespace
}  // namespace seaway::render
