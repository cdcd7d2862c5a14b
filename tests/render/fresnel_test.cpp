#include "render/fresnel.h"

#include <gtest/gtest.h>

#include <cmath>

#include "surface/angles.h"

namespace seaway::render {
namespace {

TEST(Fresnel, AgreesWithPublishedValues) {
  // Closed forms: normal incidence ((n − 1)/(n + 1))², Brewster atan n, critical angle asin 1/n.
  EXPECT_NEAR(fresnelReflectance(1.0, 1.333), 0.0204, 5e-5);
  EXPECT_NEAR(fresnelReflectance(1.0, 1.34), 0.0211, 5e-5);
  EXPECT_NEAR(fresnelReflectance(0.0, 1.34), 1.0, 1e-12);
}

TEST(Fresnel, UnpolarisedLightIsTheMeanOfBothPolarisations) {
  for (const double degrees : {5.0, 30.0, 53.27, 70.0, 85.0}) {
    const double incident = radiansFromDegrees(degrees);
    const double refracted = std::asin(std::sin(incident) / 1.34);
    const double s = std::sin(incident - refracted) / std::sin(incident + refracted);
    const double p = std::tan(incident - refracted) / std::tan(incident + refracted);
    EXPECT_NEAR(fresnelReflectance(std::cos(incident), 1.34), 0.5 * (s * s + p * p), 1e-12);
  }
}

TEST(Fresnel, ReflectsAllFromBelowBeyondTheCriticalAngle) {
  EXPECT_EQ(fresnelReflectance(std::cos(radiansFromDegrees(48.3)), 1.0 / 1.34), 1.0);
  EXPECT_LT(fresnelReflectance(std::cos(radiansFromDegrees(48.2)), 1.0 / 1.34), 1.0);
}

TEST(RoughReflection, IsTheMirrorsWhereTheWaterIsSmooth) {
  for (const double cosine : {0.05, 0.3, 1.0}) {
    const RoughReflection r = roughReflection(cosine, 0.0);
    EXPECT_NEAR(r.reflectance, fresnelReflectance(cosine), 1e-9);
    EXPECT_NEAR(r.area, cosine, 1e-9);
    EXPECT_NEAR(r.tilt, 0.0, 1e-9);
  }
}

TEST(RoughReflection, GrazingViewSeesFacetsTiltedTowardsItAndNoMirror) {
  // Closed form at cosine 0: facets count by slope·area, so E[slope²]/E[slope⁺] = σ√(π/2), weighted
  // a little towards smaller slopes by their greater reflectance; area is σ/√(2π).
  const double sigma = 0.14;
  const RoughReflection r = roughReflection(0.0, sigma);
  EXPECT_NEAR(r.area, sigma / std::sqrt(2.0 * pi), 1e-3);
  EXPECT_GT(r.tilt, 0.5 * sigma);
  EXPECT_LT(r.tilt, sigma * std::sqrt(0.5 * pi));
  EXPECT_LT(r.reflectance, 0.6);
  EXPECT_GT(r.reflectance, 0.2);
}

TEST(RoughReflection, TableHoldsTheSameValues) {
  const auto table = fresnelTable(9, 5);
  ASSERT_EQ(table.size(), 45u);
  const RoughReflection r = roughReflection(0.25, 0.5 * fresnelTableRoughest);
  EXPECT_FLOAT_EQ(table[2 * 9 + 4].x, static_cast<float>(r.reflectance));
  EXPECT_FLOAT_EQ(table[2 * 9 + 4].z, static_cast<float>(r.area));
}

}  // namespace
}  // namespace seaway::render
