#include <gtest/gtest.h>

#include <array>
#include <cstdio>

#include "render/band_limit.h"
#include "tests/render/lit_water.h"
#include "tests/render/water_picture.h"

// Slopes and glitter of drawn water against those of the sea, whatever the grid can carry.
namespace seaway::render {
namespace {

using test::WaterPicture;

struct Slopes {
  double shown = 0.0, rough = 0.0;  // mean squares
};

/// Of what a camera sees, each pixel weighed by the plane's area that it shows.
Slopes slopesIn(const WaterPicture& picture) {
  Slopes sum;
  double areas = 0.0;
  glm::vec4 seen[pixelsPerSpan + 16];
  picture.forEachSpan([&](const PixelSpan& span) {
    slopesSeen(ShadingSources{picture.constants()}, span, seen);
    for (int i = 0; i < span.count; ++i) {
      if (span.kind[i] != ShadedAs::water) continue;
      const glm::dvec3 ray(span.firstRay + span.rayStep * static_cast<float>(i));
      const double facing = -ray.z + ray.x * span.slopeX[i] + ray.y * span.slopeY[i];
      const double area = span.axial[i] * span.axial[i] / std::max(facing, 0.05);
      areas += area;
      sum.shown += area * (seen[i].x * seen[i].x + seen[i].y * seen[i].y);
      sum.rough += area * seen[i].z;
    }
  });
  return {sum.shown / areas, sum.rough / areas};
}

TEST(WaterStatistics, SlopesAndRoughnessAddUpToTheSeasAtEveryDistance) {
  const WaterSurface water = test::groupSea(0.5, 3.5);
  const double wanted = std::max(coxMunkMeanSquareSlope(View{}.light.windSpeed),
                                 BandLimit(water.waves()).totalSlope());
  const double carried = BandLimit(water.waves()).totalSlope();
  for (const double pitch : {-90.0, -50.0}) {
    for (const double height : {3.0, 10.0, 30.0, 100.0, 300.0, 1000.0, 10000.0}) {
      Slopes mean;
      // Waves of 19 m and less: as many pictures as make 1 % of the mean square's sampling error.
      const int pictures = height < 20.0 ? 150 : height < 50.0 ? 60 : 12;
      for (int i = 0; i < pictures; ++i) {
        const Camera camera =
            test::cameraAt({97.0 * i, -61.0 * i, height}, pitch, 0.0, 60.0, {96, 64});
        const Slopes slopes = slopesIn(WaterPicture(water, camera, {96, 96}, 11.0 * i));
        mean.shown += slopes.shown / pictures;
        mean.rough += slopes.rough / pictures;
      }
      std::printf("%3.0f°, %5.0f m: shown %.4f + rough %.4f = %.4f of %.4f (field %.4f)\n", pitch,
                  height, mean.shown, mean.rough, mean.shown + mean.rough, wanted, carried);
      EXPECT_NEAR((mean.shown + mean.rough) / wanted, 1.0, 0.05) << height << " m, " << pitch;
      // Ripples finer than the patch's, a third of all ripples, stay roughness even here.
      if (height <= 3.0 && pitch < -80.0) {
        EXPECT_LT(mean.rough, 0.55 * wanted);
      } else if (height >= 10000.0) {
        EXPECT_GT(mean.rough, 0.99 * wanted);
      }
    }
  }
}

struct Glitter {
  double sum = 0.0;
  int pixels = 0;
  double mean() const { return sum / std::max(pixels, 1); }
};

/// Mean radiance of glitter between two distances and within 6° of the sun's azimuth.
Glitter glitterIn(const WaterPicture& picture, double sunElevation_deg, double from, double to) {
  ShadingConstants c = picture.constants();
  const double elevation = radiansFromDegrees(sunElevation_deg);
  c.sunIsOn = c.skyIsOn = true;
  c.sunDirection =
      glm::vec3(glm::dvec3(std::cos(elevation) * unitVector(0.4), std::sin(elevation)));
  c.sunlitFacets = litFacets(c.sunDirection.z, c.seaDeviation);
  c.sunLight = glm::vec3(20.0f);
  c.deepWater = c.crestSky = c.crestSun = glm::vec3(0.0f);
  static const std::vector<std::uint32_t> black = test::evenSky(0.0f);
  Glitter glitter;
  glm::vec4 light[pixelsPerSpan + 16];
  picture.forEachSpan([&](const PixelSpan& span) {
    shadeSpan(ShadingSources{c, black.data()}, span, light);
    for (int i = 0; i < span.count; ++i) {
      if (span.kind[i] != ShadedAs::water) continue;
      const glm::dvec3 ray(span.firstRay + span.rayStep * static_cast<float>(i));
      const double distance = span.axial[i] * glm::length(ray);
      const double off = std::abs(std::remainder(std::atan2(ray.y, ray.x) - 0.4, 2.0 * pi));
      if (distance < from || distance > to || off > 0.1) continue;
      glitter.sum += light[i].g;
      ++glitter.pixels;
    }
  });
  return glitter;
}

TEST(WaterStatistics, GlitterIsAsBrightAsSixteenSamplesOfAFinerGridMakeIt) {
  const WaterSurface water = test::groupSea(0.5, 3.5);
  struct Band {
    double height, pitch, from, to;
  };
  for (const Band band : {Band{6.0, -25.0, 8.0, 40.0}, Band{12.0, -10.0, 40.0, 300.0},
                          Band{12.0, -4.0, 300.0, 3000.0}, Band{300.0, -30.0, 300.0, 3000.0}}) {
    const std::array<double, 3> suns{8.0, 20.0, 40.0};
    std::array<Glitter, 3> coarse, fine;
    // Near, single glints make the mean: more pictures.
    const int pictures = band.to < 500.0 ? 60 : 8;
    for (int i = 0; i < pictures; ++i) {
      Camera camera =
          test::cameraAt({83.0 * i, -47.0 * i, band.height}, band.pitch, 0.0, 40.0, {96, 72});
      const auto add = [&](std::array<Glitter, 3>& to, glm::ivec2 grid) {
        const WaterPicture picture(water, camera, grid, 7.0 * i);
        for (std::size_t k = 0; k < suns.size(); ++k) {
          const Glitter g = glitterIn(picture, suns[k], band.from, band.to);
          to[k].sum += g.sum;
          to[k].pixels += g.pixels;
        }
      };
      add(coarse, {128, 128});
      camera.size *= 4;
      add(fine, {384, 384});
    }
    for (std::size_t k = 0; k < suns.size(); ++k) {
      std::printf("%4.0f m, sun %2.0f°, %4.0f to %4.0f m: %.3f against %.3f, %+.1f %%\n",
                  band.height, suns[k], band.from, band.to, coarse[k].mean(), fine[k].mean(),
                  100.0 * (coarse[k].mean() / fine[k].mean() - 1.0));
      // 2.8 % at worst, of which sampling makes 0.3 %. Beyond two deviations of slope, a sun of
      // 40°, it holds because what the coarse grid lacks leans as the waves do: taken as even it
      // would be 10 % too dark.
      EXPECT_NEAR(coarse[k].mean() / fine[k].mean(), 1.0, 0.035);
    }
  }
}

}  // namespace
}  // namespace seaway::render
