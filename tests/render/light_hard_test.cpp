#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "tests/render/hard_views.h"
#include "tests/render/lit_water.h"

// Suns, lamps, waters and pictures at their limits: numbers, in all techniques.
namespace seaway::render {
namespace {

std::vector<std::unique_ptr<RenderTechnique>> allTechniques() {
  std::vector<std::unique_ptr<RenderTechnique>> techniques;
  // Other variants shade by the programs of `gpu`.
  for (const GridVariant variant : {GridVariant::gpu, GridVariant::marched}) {
    techniques.push_back(
        makeProjectedGrid(test::sharedContext(), {.grid = {48, 64}, .variant = variant}));
  }
  techniques.push_back(makeSoftwareGrid({.grid = {48, 64}}));
  techniques.push_back(makeRadialGrid({.grid = {96, 64}}));
  techniques.push_back(makePostProcess({.grid = {96, 64}}));
  techniques.push_back(makeReference({.grid = {48, 64}}));
  return techniques;
}

Mesh plate() {
  Mesh mesh;
  mesh.parts.push_back({{{-2, -2, -1}, {2, -2, 2}, {2, 2, 2}, {-2, -2, -1}, {2, 2, 2}, {-2, 2, -1}},
                        glm::vec3(0.7f)});
  mesh.boundingRadius = 3.5;
  return mesh;
}

std::vector<Lamp> manyLamps(int count) {
  std::vector<Lamp> lamps(count);
  for (int i = 0; i < count; ++i) {
    lamps[i].position = {10.0 + 3.0 * i, 2.0 * i - 20.0, 0.5 * i - 1.0};
    lamps[i].candela = std::pow(10.0, i % 7);
    lamps[i].colour = i % 3 == 0 ? glm::vec3(1, 0, 0) : glm::vec3(0.1f, 1, 0.2f);
    lamps[i].shines = i % 2 == 0;
  }
  return lamps;
}

struct Hard {
  std::string name;
  Light light{};
  Camera camera = test::cameraAt({0, 0, 5.0}, -8.0, 0.0, 60.0, {48, 30});
  std::vector<Lamp> lamps{};
  bool hasObject = true;
};

std::vector<Hard> hards() {
  std::vector<Hard> all;
  const auto add = [&](const char* name) -> Hard& { return all.emplace_back(Hard{.name = name}); };
  add("sun at the nadir").light.sunElevation = -0.5 * pi;
  add("sun at the zenith").light.sunElevation = 0.5 * pi;
  add("sun on the horizon").light.sunElevation = 0.0;
  add("clear water").light.turbidity = 0.0;
  add("clear water, linear").light.terms.extinction = Extinction::linear;
  all.back().light.turbidity = 0.0;
  add("thick fog").light.visibility = 10.0;
  add("endless sight").light.visibility = 1e6;
  add("no wind").light.windSpeed = 0.0;
  add("hurricane").light.windSpeed = 80.0;
  add("no objects").hasObject = false;
  add("one pixel").camera.size = {1, 1};
  add("camera in the water plane").camera.position.z = 0.0;
  Hard& night = add("sixteen lamps");
  night.light.sunElevation = -0.4;
  night.lamps = manyLamps(16);
  Hard& more = add("forty lamps, one in the camera");
  more.light.sunElevation = -0.4;
  more.lamps = manyLamps(40);
  more.lamps[3].position = more.camera.position;
  Hard& moon = add("new moon over a sun below it");
  moon.light.sunElevation = -0.5 * pi;
  moon.light.moon = Moon{0.5 * pi, 0.0, 0.0};
  for (const Specular specular : {Specular::phong, Specular::toman}) {
    add("rival glitter").light.terms = {specular, Extinction::linear, BackFaces::keep};
    all.back().light.sunElevation = 0.1;
  }
  return all;
}

TEST(LightHard, AllTechniquesDrawFiniteColoursThatAgree) {
  const WaterSurface water = test::groupSea(0.3, 3.0);
  const Mesh mesh = plate();
  const SceneObject object{&mesh, {14.0, 5.0, 0.2}, {1, 0, 0, 0}};
  auto techniques = allTechniques();
  for (const Hard& hard : hards()) {
    double least = 256.0, most = -1.0;
    for (const auto& technique : techniques) {
      EffectLedger effects;
      View view;
      view.water = &water;
      view.time = 2.0;
      view.camera = hard.camera;
      view.light = hard.light;
      view.lamps = hard.lamps;
      if (hard.hasObject) view.objects = {&object, 1};
      view.effects = &effects;
      const Frame frame = technique->draw(view);
      SCOPED_TRACE(hard.name + ", " + technique->name());
      test::expectSane(frame, hard.camera.size);
      // What is no number becomes black in one technique and white in another.
      const double mean = std::accumulate(frame.colour.rgb.begin(), frame.colour.rgb.end(), 0.0) /
                          static_cast<double>(frame.colour.rgb.size());
      least = std::min(least, mean);
      most = std::max(most, mean);
      const auto black = [&](std::size_t i) {
        return frame.colour.rgb[3 * i] + frame.colour.rgb[3 * i + 1] +
                   frame.colour.rgb[3 * i + 2] ==
               0;
      };
      std::size_t blacks = 0;
      for (std::size_t i = 0; i < frame.classes.size(); ++i) blacks += black(i);
      EXPECT_EQ(blacks, 0u);
    }
    // Techniques carry other waves: within a tenth of the scale; one pixel or a camera among the
    // waves may show other things.
    const bool steady = hard.camera.size.x > 1 && hard.camera.position.z > 1.0;
    if (steady) {
      EXPECT_LT(most - least, 14.0) << hard.name;
    }
  }
}

TEST(LightHard, ShadingMakesNumbersOfAllLights) {
  test::LitWater water;
  const WaterSurface sea = test::groupSea(0.3, 3.0);
  SkyDome dome;
  for (const Hard& hard : hards()) {
    EffectLedger effects;
    View view;
    view.water = &sea;
    view.camera = hard.camera;
    view.light = hard.light;
    view.lamps = hard.lamps;
    view.effects = &effects;
    Lighting lighting;
    lighting.waterIsOn = lighting.foamIsOn = lighting.hazeIsOn = true;
    lighting.sunDirection = sunDirectionOf(view);
    lighting.sunIsOn = lighting.sunDirection.z > 0.0f;
    lighting.lampsAreOn = true;
    dome.drawFor({lighting.sunDirection});
    lighting.sky = &dome;
    water.sky = dome.texels();
    for (const std::uint32_t texel : dome.texels()) {
      const glm::vec3 colour = glm::unpackF3x9_E1x5(texel);
      ASSERT_TRUE(colour.r > 0.0f && colour.g > 0.0f && colour.b > 0.0f) << hard.name;
    }
    water.constants = shadingConstants(view, lighting);
    EXPECT_TRUE(std::isfinite(water.constants.exposure));
    for (const glm::vec2 slope : {glm::vec2(0.0f), glm::vec2(1.5f, 0.0f), glm::vec2(-3.0f, 2.0f)}) {
      for (double angle = 0.0; angle <= 90.0; angle += 7.5) {
        for (const ShadedAs kind : {ShadedAs::water, ShadedAs::underside, ShadedAs::sky}) {
          water.slope = slope;
          const glm::vec3 light = water.radiance(angle, kind);
          for (int k = 0; k < 3; ++k) {
            EXPECT_TRUE(std::isfinite(light[k]) && light[k] >= 0.0f)
                << hard.name << " at " << angle << ", " << light[k];
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace seaway::render
