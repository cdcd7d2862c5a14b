#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "render/fresnel.h"
#include "render/render_technique.h"
#include "tests/render/lit_water.h"

// The terms of those who shaded water before, as options.
namespace seaway::render {
namespace {

using test::LitWater;

LitWater sunlit(Specular specular) {
  LitWater water;
  water.sky = test::evenSky(0.0f);
  water.constants.sunIsOn = true;
  water.constants.sunLight = glm::vec3(1.0f);
  water.constants.specular = static_cast<int>(specular);
  return water;
}

/// Puts the sun so many degrees from the ray that flat water mirrors, seen from 40° off the
/// vertical.
glm::vec3 sunBeside(double degrees) {
  const double angle = radiansFromDegrees(40.0 + degrees);
  return glm::vec3(glm::dvec3(std::sin(angle), 0.0, std::cos(angle)));
}

TEST(ShadingTerms, PhongsLobeHasItsExponentAndFresnel) {
  LitWater water = sunlit(Specular::phong);
  for (const double off : {0.0, 2.0, 5.0, 10.0}) {
    water.constants.sunDirection = sunBeside(off);
    const double lobe = std::pow(std::cos(radiansFromDegrees(off)), 256.0) * 257.0 / (2.0 * pi);
    const double wanted = fresnelReflectance(std::cos(radiansFromDegrees(40.0))) * lobe;
    EXPECT_NEAR(water.radiance(40.0).g, wanted, 1e-3 * wanted + 1e-6) << off;
  }
}

TEST(ShadingTerms, TomansTermIsHis) {
  LitWater water = sunlit(Specular::toman);
  for (const double off : {0.0, 3.0, 6.0}) {
    const glm::vec3 sun = sunBeside(off);
    water.constants.sunDirection = sun;
    const double d = 0.5 * std::cos(radiansFromDegrees(off)) + 0.5, sigma = 0.6;
    double s = (1.0 - fresnelReflectance(std::cos(radiansFromDegrees(40.0)))) * sun.z *
               std::pow(d, 512.0) * (1.8 * sigma + 0.2);
    s += 25.0 * s * (sigma - 0.05);
    EXPECT_NEAR(water.radiance(40.0).g, s / pi, 1e-3 * s) << off;
  }
}

TEST(ShadingTerms, LinearExtinctionEndsWhereTheExponentialLeavesAFewOfAHundred) {
  LitWater water;
  water.sky = test::evenSky(0.0f);
  // A submerged thing of radiance 1 everywhere, `apparent` below the surface seen straight down.
  water.below = test::whiteImage({-200, -200}, {400, 400}, 1.0f);
  ShadingConstants& c = water.constants;
  c.belowIsOn = true;
  c.belowLeast = glm::vec2(water.below.least);
  c.belowSize = glm::vec2(water.below.size);
  c.waterExtinction = 3.0f / glm::vec3(4.5f, 75.0f, 300.0f);
  for (const double depth : {1.0, 2.0, 4.0, 6.0}) {
    const float inverse = static_cast<float>(1.0 / (10.0 + depth / seaWaterIndex));
    water.below.nearness.assign(160000, inverse);
    const double share = 1.0 - fresnelReflectance(1.0);
    c.extinctionIsLinear = false;
    const double left = std::exp(-3.0 * depth / 4.5);
    EXPECT_NEAR(water.radiance(0.0).r / share, left, 2e-3)
        << depth;  // light's own way down is its object's
    c.extinctionIsLinear = true;
    const double line = std::max(1.0 - depth / 4.5, 0.0);
    EXPECT_NEAR(water.radiance(0.0).r / share, line, 2e-3) << depth;
  }
}

TEST(ShadingTerms, BackFacesAreTiltedUntilTheyAreSeenEdgeOn) {
  LitWater water;
  water.roughness = 0.02f;
  // Seen from 80° off the vertical, a slope of 0.5 away from the viewer faces away.
  const double edge = std::cos(radiansFromDegrees(80.0)) / std::sin(radiansFromDegrees(80.0));
  const auto seen = [&](double away, bool tilted) {
    water.slope = {static_cast<float>(-away), 0.0f};
    water.constants.backFacesAreTilted = tilted;
    return water.radiance(80.0).g;
  };
  const float edgeOn = seen(edge, true);
  for (const double away : {0.25, 0.5, 0.9}) EXPECT_NEAR(seen(away, true), edgeOn, 1e-4) << away;
  // What faces the viewer is as it was.
  EXPECT_EQ(seen(-0.1, true), seen(-0.1, false));
  EXPECT_EQ(seen(0.5 * edge, true), seen(0.5 * edge, false));
}

TEST(ShadingTerms, BackFacesThatAreKeptMirrorAnotherPartOfTheSky) {
  LitWater water;
  SkyDome dome;
  dome.drawFor({glm::vec3(0.0f, 0.6f, 0.8f)});
  water.sky = dome.texels();
  water.slope = {-0.5f, 0.0f};
  const glm::vec3 tilted = water.radiance(80.0);
  water.constants.backFacesAreTilted = false;
  const glm::vec3 kept = water.radiance(80.0);
  EXPECT_GT(glm::length(tilted - kept), 0.02f * glm::length(tilted));
}

}  // namespace
}  // namespace seaway::render
