#include "sim_bridge/scene/light_schema.h"

#include <gtest/gtest.h>

#include <string>

#include "sim_bridge/scene/scene_loader.h"
#include "sim_bridge/scene_view.h"
#include "sim_bridge/simulation.h"
#include "surface/input_error.h"
#include "tests/sim_bridge/test_support.h"

namespace seaway::bridge {
namespace {

const char* const sea =
    "sea: {anchor: {latitude_deg: 50, longitude_deg: 3}, state: {calm: {}}}\n"
    "cameras: [{name: eye, place: {latitude_deg: 50, longitude_deg: 3, height_m: 4}}]\n";

Scene sceneWith(const std::string& more) {
  const test::TempFolder folder;
  return loadScene(folder.write("scene.yaml", sea + more));
}

std::string faultOf(const std::string& more) {
  try {
    sceneWith(more);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(LightSchema, ReadsMoonAirWaterAndTermsAndKeepsOursByDefault) {
  const LightSettings plain = sceneWith("").light;
  EXPECT_FALSE(plain.moon);
  EXPECT_EQ(plain.shading.specular, render::Specular::slopes);
  EXPECT_EQ(plain.shading.extinction, render::Extinction::exponential);
  EXPECT_EQ(plain.shading.backFaces, render::BackFaces::tilt);
  const LightSettings light =
      sceneWith(
          "light: {moon: {elevation_deg: 20, azimuth_deg: 90, phase: 0.25}, turbidity_per_m: 0,\n"
          "  visibility_m: 900, shading: {specular: toman, extinction: linear, back_faces: "
          "keep}}\n")
          .light;
  ASSERT_TRUE(light.moon);
  EXPECT_EQ(light.moon->phase, 0.25);
  EXPECT_EQ(light.turbidity, 0.0);
  EXPECT_EQ(light.visibility, 900.0);
  EXPECT_EQ(light.shading.specular, render::Specular::toman);
  EXPECT_EQ(light.shading.extinction, render::Extinction::linear);
  EXPECT_EQ(light.shading.backFaces, render::BackFaces::keep);
}

TEST(LightSchema, ChoosesAToneCurveAndDither) {
  const auto seen = [](const std::string& more) {
    const Scene scene = sceneWith(more);
    const Sea water = buildSea(scene);
    EffectLedger ledger(scene.effects);
    return SceneView(scene)
        .view(Simulation(scene, water), scene.cameras[0], {32, 24}, ledger)
        .light;
  };
  EXPECT_EQ(seen("").toneCurve, render::ToneCurve::filmic);
  EXPECT_TRUE(seen("").dithers);
  EXPECT_EQ(seen("light: {tone_map: reinhard}\n").toneCurve, render::ToneCurve::reinhard);
  const render::Light light = seen("light: {tone_map: linear, dither: false}\n");
  EXPECT_EQ(light.toneCurve, render::ToneCurve::linear);
  EXPECT_FALSE(light.dithers);
  const std::string fault = faultOf("light: {tone_map: aces}\n");
  for (const char* word :
       {"scene.yaml:3", "light.tone_map", "aces", "filmic", "reinhard", "linear"}) {
    EXPECT_NE(fault.find(word), std::string::npos) << fault;
  }
}

TEST(LightSchema, SaysWhatIsAllowedWhereAWordOrANumberIsNot) {
  EXPECT_NE(faultOf("light: {shading: {specular: blinn}}\n").find("phong"), std::string::npos);
  EXPECT_NE(faultOf("light: {turbidity_per_m: -1}\n").find("turbidity_per_m"), std::string::npos);
  EXPECT_NE(faultOf("light: {moon: {phase: 2}}\n").find("phase"), std::string::npos);
  EXPECT_NE(faultOf("lights: [{name: quay}]\n").find("place"), std::string::npos);
}

TEST(LightSchema, LampsOfTheSceneStandInItsViewsByNightAlone) {
  const std::string lamp =
      "lights: [{name: quay, place: {latitude_deg: 50.001, longitude_deg: 3}, height_m: 7,\n"
      "  colour: [1, 0.5, 0], candela: 30}]\n";
  for (const bool night : {false, true}) {
    const Scene scene =
        sceneWith(lamp + "light: {sun: {elevation_deg: " + (night ? "-20" : "20") + "}}\n");
    const Sea water = buildSea(scene);
    const Simulation simulation(scene, water);
    SceneView views(scene);
    EffectLedger effects;
    const render::View view = views.view(simulation, scene.cameras[0], {8, 8}, effects);
    ASSERT_EQ(view.lamps.size(), night ? 1u : 0u);
    if (!night) continue;
    EXPECT_EQ(view.lamps[0].candela, 30.0);
    EXPECT_EQ(view.lamps[0].position.z, 7.0);
    EXPECT_NEAR(view.lamps[0].position.y, 111.2, 0.2);  // a thousandth of a degree north
    EXPECT_TRUE(view.lamps[0].shines);
  }
}

}  // namespace
}  // namespace seaway::bridge
