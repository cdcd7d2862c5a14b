#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <glm/geometric.hpp>
#include <numeric>

#include "render/shading/night_constants.h"
#include "tests/render/lit_water.h"
#include "tests/render/seas.h"

// Dusk, night, moon and lamps.
namespace seaway::render {
namespace {

using test::LitWater;

glm::vec3 sunAt(double elevation_deg) {
  return skyDirection(radiansFromDegrees(elevation_deg), 0.4);
}

struct Scene {
  WaterSurface water = test::groupSea(0.2, 2.5);
  Camera camera = test::cameraAt({0, 0, 6.0}, -6.0, 0.0, 50.0, {160, 100});
  Light light;
  std::vector<Lamp> lamps;
  EffectSettings settings{};
  std::vector<EffectReport> report;

  explicit Scene(double sun_deg) {
    light.sunElevation = radiansFromDegrees(sun_deg);
    light.windSpeed = 3.0;
  }
  Frame draw() { return draw(*makeSoftwareGrid({.grid = {96, 128}})); }
  Frame draw(RenderTechnique& technique) {
    EffectLedger effects(settings);
    View view;
    view.water = &water;
    view.time = 3.0;
    view.camera = camera;
    view.light = light;
    view.lamps = lamps;
    view.effects = &effects;
    Frame frame = technique.draw(view);
    report = effects.report();
    return frame;
  }
  const EffectReport& operator[](Effect effect) const {
    return report[static_cast<std::size_t>(effect)];
  }
};

double meanByte(const Frame& frame) {
  return std::accumulate(frame.colour.rgb.begin(), frame.colour.rgb.end(), 0.0) /
         frame.colour.rgb.size();
}

/// A lamp 60 m ahead of test::cameraAt's cameras and some way to the side.
Lamp lampAhead(double height = 5.0, double across = 0.0) {
  Lamp lamp;
  lamp.position = glm::dvec3(60.0 * unitVector(0.4) + across * unitVector(0.4 + 0.5 * pi), height);
  lamp.candela = 50.0;
  return lamp;
}

TEST(Night, TheSkyDarkensWithoutAJumpFromDayToTheDeepOfNight) {
  SkyDome dome;
  glm::vec3 before(0.0f);
  double largest = 0.0, ratio = 1.0;
  for (double elevation = 12.0; elevation >= -24.0; elevation -= 0.5) {
    dome.drawFor({sunAt(elevation)});
    const glm::vec3 mean = dome.mean();
    for (int k = 0; k < 3; ++k) {
      ASSERT_GT(mean[k], 0.0f);
      if (before[k] > 0.0f)
        largest = std::max<double>(largest, std::abs(std::log(mean[k] / before[k])));
    }
    if (before.g > 0.0f) {
      EXPECT_LT(mean.g, 1.001f * before.g) << elevation;
      ratio = mean.g / before.g;
    }
    before = mean;
  }
  std::printf("largest step of half a degree: %.1f %%\n", 100.0 * largest);
  // Light falls by e for every 2° on the average, faster where the sun no longer reaches the air.
  EXPECT_LT(largest, 0.45);
  EXPECT_NEAR(ratio, 1.0, 0.01);  // night has no sun in it
}

TEST(Night, TheHazeOfTheHorizonIsTheSkysOwnColourThere) {
  for (const double elevation : {30.0, 8.0, 3.0, 0.0, -2.0, -6.0, -12.0, -18.0, -30.0}) {
    Light light;
    light.moon = Moon{0.4, 2.0, 0.5};
    Lighting lighting;
    lighting.sunDirection = sunAt(elevation);
    lighting.moonDirection = directionOf(*light.moon);
    lighting.moonPart = elevation < 0.0 ? moonPart(*light.moon, lighting.sunDirection) : 0.0f;
    lighting.hazeIsOn = true;
    SkyDome dome;
    dome.drawFor({lighting.sunDirection, lighting.moonDirection, lighting.moonPart});
    lighting.sky = &dome;
    EffectLedger effects;
    View view;
    view.light = light;
    view.effects = &effects;
    view.camera = test::cameraAt({0, 0, 3}, 0.0);
    ShadingConstants c = shadingConstants(view, lighting);
    c.starLight = 0.0f;
    double worst = 0.0;
    for (double azimuth = 0.0; azimuth < 2.0 * pi; azimuth += 0.3) {
      PixelSpan span;
      span.count = 2;
      span.firstRay = glm::vec3(glm::dvec3(unitVector(azimuth), 0.0));
      for (int i = 0; i < 16; ++i) {
        span.kind[i] = i == 0 ? ShadedAs::sky : ShadedAs::object;
        span.axial[i] = i == 0 ? 1.0f : 1e7f;  // beyond all that haze lets through
        for (int k = 0; k < 3; ++k) span.normal[k][i] = span.reflectance[k][i] = 0.5f;
      }
      glm::vec4 light_[16];
      shadeSpan(ShadingSources{c, dome.texels().data()}, span, light_);
      for (int k = 0; k < 3; ++k) {
        worst = std::max<double>(worst, std::abs(light_[0][k] / light_[1][k] - 1.0f));
      }
    }
    std::printf("sun at %3.0f: haze and sky differ by %.1f %%\n", elevation, 100.0 * worst);
    // Texels hold 9 bits of a shared exponent; the horizon lies half a texel (0.1°) above.
    EXPECT_LT(worst, 0.08) << elevation;
  }
}

TEST(Night, PicturesGrowDarkButStayReadable) {
  double before = 1e9;
  for (const double elevation : {5.0, -1.0, -6.0, -12.0, -18.0, -60.0}) {
    const double mean = meanByte(Scene(elevation).draw());
    std::printf("sun at %3.0f: mean byte %.0f\n", elevation, mean);
    EXPECT_LT(mean, before + 2.0);
    EXPECT_GT(mean, 12.0);
    before = mean;
  }
  EXPECT_LT(before, 60.0);
}

TEST(Night, LampsAreSeenWithinTheirArcsOnly) {
  Lamp lamp;
  const auto from = [&](double degrees) {
    return shownPart(lamp, glm::dvec3(100.0 * unitVector(radiansFromDegrees(degrees)), 1.0));
  };
  lamp.arc = radiansFromDegrees(112.5);
  lamp.towards = glm::dvec3(unitVector(radiansFromDegrees(56.25)), 0.0);
  for (const double inside : {0.1, 30.0, 112.4}) EXPECT_EQ(from(inside), 1.0) << inside;
  for (const double outside : {-3.1, 115.6, 180.0, -90.0}) EXPECT_EQ(from(outside), 0.0) << outside;
  EXPECT_NEAR(from(-1.5), 0.5, 0.01);
  EXPECT_EQ(shownPart(lamp, {50.0, 50.0, 90.0}), 0.0);  // 52° above its plane
  lamp.arc = 2.0 * pi;
  EXPECT_EQ(shownPart(lamp, {0.0, 0.0, -90.0}), 1.0);
}

TEST(Night, ALampShowsWhereItIs) {
  Scene scene(-30.0);
  const Frame dark = scene.draw();
  EXPECT_EQ(scene[Effect::lights].state, EffectState::idle);
  scene.lamps = {lampAhead(7.0)};
  scene.lamps[0].candela = 0.03;  // no brighter than the picture can show
  const Frame lit = scene.draw();
  EXPECT_EQ(scene[Effect::lights].state, EffectState::on);
  glm::dvec2 sum(0.0);
  double weights = 0.0;
  for (int y = 0; y < 100; ++y) {
    for (int x = 0; x < 160; ++x) {
      const std::size_t i = static_cast<std::size_t>(y) * 160 + x;
      const int added = lit.colour.rgb[3 * i] - dark.colour.rgb[3 * i];
      if (lit.classes[i] != PixelClass::sky || added < 8) continue;
      sum += glm::dvec2(x, y) * double(added);
      weights += added;
    }
  }
  // Ahead, 1 m above the eye at 60 m: 0.95° up with the axis 6° down, half a degree a pixel.
  const double row =
      49.5 - 50.0 * std::tan(radiansFromDegrees(6.95)) / std::tan(radiansFromDegrees(25.0));
  ASSERT_GT(weights, 100.0);
  EXPECT_NEAR(sum.x / weights, 79.5, 0.5);
  EXPECT_NEAR(sum.y / weights, row, 0.5);
}

TEST(Night, ALampGlittersOnTheWaterBelowIt) {
  Scene scene(-30.0);
  const Frame dark = scene.draw();
  scene.lamps = {lampAhead(7.0)};
  const Frame lit = scene.draw();
  const auto added = [&](int column) {
    double sum = 0.0;
    for (int y = 0; y < 100; ++y) {
      for (int x = column - 12; x < column + 12; ++x) {
        const std::size_t i = static_cast<std::size_t>(y) * 160 + x;
        if (lit.classes[i] == PixelClass::water)
          sum += lit.colour.rgb[3 * i] - dark.colour.rgb[3 * i];
      }
    }
    return sum;
  };
  std::printf("light below the lamp %.0f, beside it %.0f\n", added(80), added(20));
  EXPECT_GT(added(80), 6.0 * std::max(added(20), 1.0));
}

TEST(Night, ByDayLampsAndMoonAreIdleAndLeaveThePictureAlone) {
  Scene scene(20.0);
  const Frame bare = scene.draw();
  scene.lamps = {lampAhead(), lampAhead(3.0, 10.0)};
  scene.light.moon = Moon{0.3, 0.4, 0.5};
  const Frame same = scene.draw();
  EXPECT_EQ(bare.colour.rgb, same.colour.rgb);
  for (const Effect effect : {Effect::lights, Effect::moon}) {
    EXPECT_EQ(scene[effect].state, EffectState::idle);
    EXPECT_EQ(scene[effect].reason, "the sun is up");
    EXPECT_EQ(scene[effect].memoryBytes, 0u);
  }
}

TEST(Night, SwitchedOffLampsAndMoonAreNotThere) {
  Scene scene(-30.0);
  const Frame bare = scene.draw();
  scene.lamps = {lampAhead()};
  scene.light.moon = Moon{0.3, 0.4, 0.5};
  for (const Effect effect : {Effect::lights, Effect::moon}) {
    scene.settings[static_cast<std::size_t>(effect)] = EffectSetting::off;
  }
  EXPECT_EQ(bare.colour.rgb, scene.draw().colour.rgb);
}

TEST(Night, AMoonLightsTheWaterByItsPhase) {
  const glm::vec3 night = sunAt(-30.0);
  const auto part = [&](double phase) { return moonPart(Moon{0.5, 0.0, phase}, night); };
  // Krisciunas & Schaefer 1991: 2.60 magnitudes at 90°, so a quarter is 11 times fainter than full.
  EXPECT_NEAR(part(0.5) / part(0.25), std::pow(10.0, 0.4 * (0.026 * 90.0 + 4e-9 * 6.561e7)), 0.01);
  EXPECT_FLOAT_EQ(part(0.25), part(0.75));
  EXPECT_LT(part(0.0), 1e-3f * part(0.5));
  EXPECT_EQ(moonPart(Moon{}, sunAt(5.0)), 0.0f);
  Scene scene(-30.0);
  scene.light.moon = Moon{0.25, 0.4, 0.5};
  scene.camera = test::cameraAt({0, 0, 6.0}, 0.0, 0.0, 50.0, {160, 100});
  const Frame moonlit = scene.draw();
  EXPECT_EQ(scene[Effect::moon].state, EffectState::on);
  EXPECT_EQ(scene[Effect::sun].state, EffectState::idle);
  const auto columns = [&](int from, int to) {
    double sum = 0.0;
    for (int y = 60; y < 100; ++y) {
      for (int x = from; x < to; ++x) sum += moonlit.colour.rgb[3 * (160 * y + x) + 1];
    }
    return sum / (to - from);
  };
  EXPECT_GT(columns(75, 85), 1.5 * columns(0, 10));  // its glitter
}

TEST(Night, TheMoonsDiscIsLitByItsPhase) {
  // Seen with 0.01° a pixel: the disc is 69 pixels across.
  const auto litPart = [](double phase, int bright) {
    Scene scene(-30.0);
    scene.light.moon = Moon{0.5, 0.4, phase};
    scene.light.sunDirection = 2.0;
    scene.camera = test::cameraAt({0, 0, 6.0}, radiansFromDegrees(1.0), 0.0, 1.0, {100, 100});
    scene.camera.worldFromCamera = attitude(0.4, 0.5, 0.0);
    const Frame frame = scene.draw();
    int lit = 0;
    for (std::size_t i = 1; i < frame.colour.rgb.size(); i += 3)
      lit += frame.colour.rgb[i] > bright;
    return lit / (100.0 * 100.0);
  };
  // Brighter than the glare about a full moon; a crescent has little.
  const double full = litPart(0.5, 235), half = litPart(0.25, 200), crescent = litPart(0.1, 150);
  std::printf("lit parts of the disc: %.3f, %.3f, %.3f\n", full, half / full, crescent / full);
  EXPECT_NEAR(half / full, 0.5, 0.08);
  // (1 − cos 36°)/2; its limb is faint.
  EXPECT_NEAR(crescent / full, 0.095, 0.07);
}

TEST(Night, AllTechniquesShowTheSameNight) {
  Scene scene(-14.0);
  scene.camera.size = {96, 60};
  scene.lamps = {lampAhead(7.0, 6.0), lampAhead(4.0, -9.0)};
  scene.lamps[0].colour = {1.0f, 0.02f, 0.02f};
  scene.light.moon = Moon{0.2, 0.6, 0.4};
  scene.light.terms.extinction = Extinction::linear;
  const Frame first = scene.draw();
  const auto compare = [&](std::unique_ptr<RenderTechnique> technique, double tolerance) {
    const Frame other = scene.draw(*technique);
    double sum = 0.0;
    for (std::size_t i = 0; i < first.colour.rgb.size(); ++i) {
      sum += std::abs(int{first.colour.rgb[i]} - int{other.colour.rgb[i]});
    }
    const double mean = sum / first.colour.rgb.size();
    std::printf("%s: mean difference %.2f, of the mean %.2f\n", technique->name().c_str(), mean,
                meanByte(other) - meanByte(first));
    EXPECT_LT(mean, tolerance);
    EXPECT_NEAR(meanByte(other), meanByte(first), 3.0);
  };
  // The same grid drawn through GL differs by rounding; others carry other waves, which glitter
  // elsewhere.
  for (const GridVariant variant :
       {GridVariant::cpuVertices, GridVariant::gpu, GridVariant::marched}) {
    compare(makeProjectedGrid(test::sharedContext(), {.grid = {96, 128}, .variant = variant}), 1.0);
  }
  compare(makeReference({.grid = {96, 128}}), 3.0);
  compare(makeRadialGrid({.grid = {192, 128}}), 10.0);
  compare(makePostProcess({.grid = {192, 128}}), 10.0);
}

}  // namespace
}  // namespace seaway::render
