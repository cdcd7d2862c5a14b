#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "render/band_limit.h"
#include "render/fresnel.h"
#include "tests/render/lit_water.h"
#include "tests/render/seas.h"

// Where the light that water sends to the viewer comes from.
namespace seaway::render {
namespace {

using test::LitWater;

/// Mean-square slope of Cox and Munk's sea.
double slopeOf(double wind) { return coxMunkMeanSquareSlope(wind); }

/// Slope-averaged reflectance of a Gaussian sea with these variances along and across the line of
/// sight, by direct summation over both slopes (Zeisse 1995, doi:10.1364/JOSAA.12.002022): each
/// facet counts with its area projected towards the viewer, (v·n)/n_z = v_z + s v_h, none from
/// behind.
double summedReflectance(double cosine, double along, double across) {
  const double sine = std::sqrt(1.0 - cosine * cosine);
  constexpr int steps = 160;
  double areas = 0.0, reflected = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double u = -6.0 + 12.0 * (i + 0.5) / steps, x = u * std::sqrt(along);
    const double area = cosine + x * sine;
    if (area <= 0.0) continue;
    for (int j = 0; j < steps; ++j) {
      const double v = -6.0 + 12.0 * (j + 0.5) / steps, y = v * std::sqrt(across);
      const double weight = std::exp(-0.5 * (u * u + v * v)) * area;
      areas += weight;
      reflected += weight * fresnelReflectance(area / std::sqrt(1.0 + x * x + y * y));
    }
  }
  return reflected / areas;
}

TEST(WaterEnergy, InAWhiteFurnaceAllWaterIsWhite) {
  LitWater water;
  water.constants.deepWater = glm::vec3(1.0f);
  const WaterSurface sea = test::moderateSea();
  const LocalImage white = test::whiteImage({-200, -200}, {400, 400}, 0.05f);
  water.mirrored = water.below = white;
  for (const bool hasObjects : {false, true}) {
    for (const double wind : {0.0, 3.0, 8.0, 15.0, 30.0}) {
      EffectLedger effects;
      View view;
      view.water = &sea;
      view.light.windSpeed = wind;
      view.effects = &effects;
      const ShadingConstants c = shadingConstants(view, {.waterIsOn = true});
      LitWater lit = water;
      lit.constants = c;
      lit.constants.skyIsOn = true;
      lit.constants.sunIsOn = lit.constants.foamIsOn = false;
      lit.constants.deepWater = glm::vec3(1.0f);
      lit.constants.crestSky = lit.constants.crestSun = lit.constants.waterExtinction =
          glm::vec3(0.0f);
      lit.constants.mirrorIsOn = lit.constants.belowIsOn = hasObjects;
      lit.constants.mirrorLeast = lit.constants.belowLeast = glm::vec2(white.least);
      lit.constants.mirrorSize = lit.constants.belowSize = glm::vec2(white.size);
      lit.constants.mirrorNearest = 1.0f;
      lit.constants.mirrorFarthest = 40.0f;
      for (const float roughness : {0.0f, 0.003f, 0.02f, 0.08f, 0.2f}) {
        for (const glm::vec2 slope :
             {glm::vec2(0.0f), glm::vec2(0.3f, -0.1f), glm::vec2(-0.2f, 0.3f)}) {
          for (double angle = 0.0; angle < 90.0; angle += 4.5) {
            lit.roughness = roughness;
            lit.slope = slope;
            const glm::vec3 light = lit.radiance(angle);
            for (int k = 0; k < 3; ++k) {
              ASSERT_NEAR(light[k], 1.0f, 0.01f)
                  << wind << " m/s, " << roughness << ", " << angle << "°, objects " << hasObjects;
            }
          }
        }
      }
    }
  }
}

TEST(WaterEnergy, ReflectsWhatCoxAndMunksSlopesReflect) {
  LitWater water;
  double worst = 0.0, worstTurned = 0.0;
  for (const double wind : {1.0, 3.0, 5.0, 7.0, 10.0, 12.5, 15.0}) {
    water.roughness = static_cast<float>(slopeOf(wind));
    for (double angle = 0.0; angle <= 85.0; angle += 2.5) {
      const double cosine = std::cos(radiansFromDegrees(angle));
      const double drawn = water.radiance(angle).g;
      const double half = 0.5 * slopeOf(wind);
      const double wanted = summedReflectance(cosine, half, half);
      worst = std::max(worst, std::abs(drawn / wanted - 1.0));
      EXPECT_NEAR(drawn / wanted, 1.0, 0.03) << wind << " m/s at " << angle;
      // Upwind and crosswind variances as they found them, seen from all around.
      const double up = 3.16e-3 * wind, cross = 0.003 + 1.92e-3 * wind;
      double turned = 0.0;
      for (int i = 0; i < 8; ++i) {
        const double c = std::cos(pi * (i + 0.5) / 16.0), c2 = c * c;
        turned +=
            summedReflectance(cosine, c2 * up + (1.0 - c2) * cross, c2 * cross + (1.0 - c2) * up) /
            8.0;
      }
      worstTurned = std::max(worstTurned, std::abs(drawn / turned - 1.0));
      EXPECT_NEAR(drawn / turned, 1.0, 0.03) << wind << " m/s at " << angle << ", all round";
    }
  }
  std::printf("worst: %.2f %% of isotropic slopes, %.2f %% of the mean over azimuths\n",
              100.0 * worst, 100.0 * worstTurned);
}

TEST(WaterEnergy, WavesThatLeanReflectAsTheirSlopesAlongAndAcrossTheViewDo) {
  double worst = 0.0;
  // The table takes slopes across the view for as large as those along it, which costs up to 5.6 %
  // at a lean of 0.8 and 12.5 m/s.
  for (const double lean : {-0.4, 0.4, 0.8}) {
    for (const double wind : {3.0, 7.0, 12.5}) {
      LitWater water;
      water.roughness = static_cast<float>(slopeOf(wind));
      water.constants.waveLean = glm::vec2(static_cast<float>(lean), 0.0f);
      for (double angle = 0.0; angle <= 85.0; angle += 5.0) {
        const double half = 0.5 * slopeOf(wind);
        const double wanted = summedReflectance(std::cos(radiansFromDegrees(angle)),
                                                half * (1.0 + lean), half * (1.0 - lean));
        const double drawn = water.radiance(angle).g;
        worst = std::max(worst, std::abs(drawn / wanted - 1.0));
        EXPECT_NEAR(drawn / wanted, 1.0, lean < 0.5 ? 0.03 : 0.06)
            << wind << " m/s at " << angle << ", " << lean;
      }
    }
  }
  std::printf("worst: %.2f %%\n", 100.0 * worst);
}

TEST(WaterEnergy, SmoothWaterReflectsByFresnelToAByteOnBothSides) {
  LitWater water;
  double worst = 0.0;
  for (double angle = 0.0; angle < 90.0; angle += 0.125) {
    const double cosine = std::cos(radiansFromDegrees(angle));
    const double above = water.radiance(angle).g - fresnelReflectance(cosine);
    worst = std::max(worst, std::abs(above));
    ASSERT_LE(std::abs(above), 1.0 / 255.0) << angle;
  }
  // From below: the mirror shows the water itself, the window a black sky.
  water.sky = test::evenSky(0.0f);
  water.constants.eyeVeil = glm::vec3(1.0f);
  for (double angle = 0.0; angle < 90.0; angle += 0.125) {
    const double cosine = std::cos(radiansFromDegrees(angle));
    // Less light comes from deeper down (waterLight).
    const double below = water.radiance(angle, ShadedAs::underside).g * std::exp(0.9 * cosine) -
                         fresnelReflectance(cosine, 1.0 / seaWaterIndex);
    // Near the critical angle reflectance rises by 0.4 in the last 0.01°: floats of a cosine.
    const double edge = std::abs(angle - 48.268);
    if (edge > 0.02) worst = std::max(worst, std::abs(below));
    ASSERT_LE(std::abs(below), edge > 0.02 ? 1.0 / 255.0 : 0.05) << angle;
  }
  std::printf("worst: %.5f, a byte is %.5f\n", worst, 1.0 / 255.0);
}

/// Mirrored radiance of suns that together are a white sky.
double glitterOfAllSuns(LitWater water, double wind, double angle) {
  constexpr int rings = 48, spokes = 96;
  water.sky = test::evenSky(0.0f);
  water.constants.sunIsOn = true;
  double sum = 0.0;
  for (int ring = 0; ring < rings; ++ring) {
    const double height = (ring + 0.5) / rings;  // even in solid angle
    for (int spoke = 0; spoke < spokes; ++spoke) {
      const glm::dvec2 level =
          unitVector(2.0 * pi * spoke / spokes) * std::sqrt(1.0 - height * height);
      water.constants.sunDirection = glm::vec3(glm::dvec3(level, height));
      water.constants.sunlitFacets =
          litFacets(static_cast<float>(height), static_cast<float>(std::sqrt(0.5 * slopeOf(wind))));
      water.constants.sunLight = glm::vec3(2.0 * pi / (rings * spokes));
      sum += water.radiance(angle).g;
    }
  }
  return sum;
}

TEST(WaterEnergy, GlitterOfSunsAllOverTheSkyIsAWhiteSkysReflection) {
  for (const double lean : {0.0, 0.6}) {
    for (const double wind : {3.0, 7.0, 15.0}) {
      for (const double angle : {0.0, 30.0, 50.0, 65.0, 75.0}) {
        LitWater water;
        water.roughness = static_cast<float>(slopeOf(wind));
        water.constants.waveLean = glm::vec2(static_cast<float>(lean), 0.0f);
        const double wanted = water.radiance(angle).g;
        const double sum = glitterOfAllSuns(water, wind, angle);
        std::printf("%4.0f m/s %3.0f°, lean %.1f: glitter %.4f, mirrored sky %.4f\n", wind, angle,
                    lean, sum, wanted);
        // Suns light no facet that another hides from them; the mirrored sky, which is as bright
        // behind a wave, has no such loss. It never grows beyond a mirror's light.
        // Waves that lean along the view are as steep there as a stronger wind's.
        const bool hides = angle > 55.0 || wind * (1.0 + lean) > 10.0;
        const double from = lean > 0.0 ? 25.0 : 40.0, least = lean > 0.0 ? 0.65 : 0.70;
        EXPECT_LE(sum / wanted, 1.01) << wind << " m/s at " << angle;
        EXPECT_GE(sum / wanted, hides && angle > from ? least : 0.97)
            << wind << " m/s at " << angle << ", " << lean;
      }
    }
  }
}

}  // namespace
}  // namespace seaway::render
