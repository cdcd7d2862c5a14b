#include <gtest/gtest.h>

#include <cstdio>

#include "render/fresnel.h"
#include "render/local_light.h"
#include "render/waterline.h"
#include "surface/constants.h"
#include "tests/render/stage.h"

// The water from inside: Snell's window, total reflection, and views that the surface cuts.
namespace seaway::render {
namespace {

using test::Stage;

Stage lookingUp(double depth, double fov_deg, glm::ivec2 size) {
  Stage stage;
  stage.camera = test::cameraAt({0, 0, -depth}, 90.0, 0.0, fov_deg, size);
  stage.camera.worldFromCamera = attitude(0.0, 0.5 * pi, 0.0);
  return stage;
}

/// Radiance of the underside of a plane, along the picture's middle row from its middle rightwards.
std::vector<float> rowOfUnderside(const Stage& stage, bool smooth) {
  EffectLedger effects;
  const View view = stage.view(effects);
  Lighting lighting;
  lighting.sunIsOn = lighting.waterIsOn = lighting.cameraIsUnderWater = true;
  lighting.sunDirection = sunDirectionOf(view);
  ShadingConstants constants = shadingConstants(view, lighting);
  if (smooth) {
    constants.hairSlope = 0.0f;
    constants.ripplesAreOn = false;
  }
  PixelSpan span;
  span.count = pixelsPerSpan;
  span.rayStep = constants.right * (2.0f / stage.camera.size.x);
  span.firstRay = constants.forward;
  std::fill_n(span.kind, pixelsPerSpan, ShadedAs::underside);
  std::fill_n(span.axial, pixelsPerSpan, static_cast<float>(-stage.camera.position.z));
  for (float* of : {span.slopeX, span.slopeY, span.missingSlope, span.height}) {
    std::fill_n(of, pixelsPerSpan, 0.0f);
  }
  glm::vec4 radiance[pixelsPerSpan + 16];
  shadeSpan(ShadingSources{constants}, span, radiance);
  std::vector<float> row;
  for (int i = 0; i < pixelsPerSpan; ++i)
    row.push_back(radiance[i].x + radiance[i].y + radiance[i].z);
  return row;
}

/// Where a row falls most, and the middle of all its fall, in pixels from the first.
glm::dvec2 fallOf(const std::vector<float>& row, std::size_t from) {
  double steepest = 0.0, fall = 0.0, sum = 0.0, all = 0.0;
  for (std::size_t i = from; i + 1 < row.size(); ++i) {
    const double step = std::max(row[i] - row[i + 1], 0.0f);
    if (step > fall) fall = step, steepest = static_cast<double>(i) + 0.5;
    sum += step * (static_cast<double>(i) + 0.5);
    all += step;
  }
  return {steepest, sum / all};
}

TEST(UnderWater, TheRimOfTheWindowLiesAtTheCriticalAngle) {
  const double critical = std::asin(1.0 / seaWaterIndex);
  EXPECT_NEAR(degreesFromRadians(critical), 48.27, 0.01);
  Stage stage = lookingUp(3.0, 110.0, {201, 201});
  const double rim = std::tan(critical) / (2.0 * std::tan(radiansFromDegrees(55.0)) / 201);
  // Of water without any roughness.
  EXPECT_NEAR(fallOf(rowOfUnderside(stage, true), 30).x, rim, 1.0);
  // Still water has Cox and Munk's slick of a windless sea, 0.04 along an axis, which blurs the rim
  // by 2.2°, 5 pixels: all techniques blur it alike.
  const double blurred = fallOf(rowOfUnderside(stage, false), 30).y;
  EXPECT_NEAR(blurred, rim, 5.0);
  std::vector<float> software;
  for (const auto& way : test::everyWay({64, 64})) {
    const Frame frame = stage.draw(*way.technique);
    std::vector<float> row;
    for (int x = 100; x < 200; ++x)
      row.push_back(static_cast<float>(test::brightness(frame, x, 100)));
    if (software.empty()) software = row;
    for (std::size_t i = 0; i < row.size(); ++i) {
      EXPECT_NEAR(row[i], software[i], 9.0) << way.name << ' ' << i;  // three of 255 a channel
    }
  }
}

TEST(UnderWater, BeyondItAllIsMirroredFromBelow) {
  for (const double degrees : {48.3, 50.0, 65.0, 89.9}) {
    EXPECT_EQ(fresnelReflectance(std::cos(radiansFromDegrees(degrees)), 1.0 / seaWaterIndex), 1.0);
  }
  // A bright box in the water, seen by way of the surface 65° from the vertical: where the mirrored
  // world shows it.
  const Mesh mesh = test::boxMesh({-0.3f, -0.3f, -0.3f}, {0.3f, 0.3f, 0.3f}, glm::vec3(0.9f));
  Stage stage = lookingUp(2.0, 60.0, {201, 201});
  stage.camera.worldFromCamera = attitude(0.0, radiansFromDegrees(25.0), 0.0);
  stage.objects = {{&mesh, {8.0, 0.0, -1.7}, {1, 0, 0, 0}}};
  Stage bare = stage;
  bare.objects.clear();
  // Its middle is mirrored to 1.7 m above the water.
  const glm::dvec2 wanted = test::pixelOf(stage.camera, {8.0, 0.0, 1.7});
  for (const auto& way : test::everyWay({64, 128})) {
    const Frame with = stage.draw(*way.technique), without = bare.draw(*way.technique);
    glm::dvec2 sum(0.0);
    double weights = 0.0;
    for (int y = 0; y < wanted.y + 20; ++y) {  // the box itself is lower
      for (int x = 0; x < 201; ++x) {
        if (with.classes[static_cast<std::size_t>(y) * 201 + x] != PixelClass::water) continue;
        const double change =
            std::abs(test::brightness(with, x, y) - test::brightness(without, x, y));
        sum += change * glm::dvec2(x, y);
        weights += change;
      }
    }
    ASSERT_GT(weights, 50.0) << way.name;
    EXPECT_NEAR(sum.x / weights, wanted.x, 1.0) << way.name;
    EXPECT_NEAR(sum.y / weights, wanted.y, 1.5) << way.name;
  }
}

/// The direction, by its tangent from the vertical, in which an eye sees a point: bisection.
double refractedTangent(double depth, double far, double high) {
  double low = 0.0, most = far;
  for (int i = 0; i < 200; ++i) {
    const double x = 0.5 * (low + most);
    const double off =
        seaWaterIndex * x / std::hypot(x, depth) - (far - x) / std::hypot(far - x, high);
    (off > 0.0 ? most : low) = x;
  }
  return low / depth;
}

TEST(UnderWater, AThingAboveIsSeenThroughTheWindowAtTheRefractedAngle) {
  const Mesh mesh = test::boxMesh({-0.2f, -0.2f, -0.2f}, {0.2f, 0.2f, 0.2f}, glm::vec3(0.02f));
  Stage stage = lookingUp(3.0, 100.0, {201, 201});
  const double perPixel = 2.0 * std::tan(radiansFromDegrees(50.0)) / 201;
  for (const glm::dvec2 place :
       {glm::dvec2(1.0, 6.0), glm::dvec2(6.0, 6.0), glm::dvec2(12.0, 5.0)}) {
    stage.objects = {{&mesh, {place.x, 0.0, place.y}, {1, 0, 0, 0}}};
    Stage bare = stage;
    bare.objects.clear();
    const double wanted = 100.0 + refractedTangent(3.0, place.x, place.y) / perPixel;
    for (const auto& way : test::everyWay({64, 64})) {
      const Frame with = stage.draw(*way.technique), without = bare.draw(*way.technique);
      double sum = 0.0, weights = 0.0;
      for (int y = 0; y < 201; ++y) {
        for (int x = 0; x < 201; ++x) {
          const double change =
              std::abs(test::brightness(with, x, y) - test::brightness(without, x, y));
          sum += change * y;
          weights += change;
        }
      }
      ASSERT_GT(weights, 30.0) << way.name << ' ' << place.x;
      // Heading 0 is east and the camera looks up: what is ahead lies at the bottom or the top.
      EXPECT_NEAR(std::abs(sum / weights - 100.0), wanted - 100.0, 1.5) << way.name << place.x;
    }
  }
}

TEST(UnderWater, ItIsDecidedByWhereTheSurfaceCutsTheView) {
  using enum EffectState;
  const auto technique = makeSoftwareGrid({.grid = {64, 64}});
  Stage stage;
  const auto stateAt = [&](double height) {
    stage.camera = test::cameraAt({0, 0, height}, 0.0, 0.0, 60.0, {64, 48});
    return stage.report(*technique, Effect::underWater).state;
  };
  EXPECT_EQ(stateAt(4.0), idle);
  EXPECT_EQ(stateAt(0.2), idle);
  EXPECT_EQ(stateAt(0.02), on);
  EXPECT_EQ(stateAt(0.0), on);
  EXPECT_EQ(stateAt(-0.02), on);
  EXPECT_EQ(stateAt(-3.0), on);
  stage = stage.without(Effect::underWater);
  EXPECT_EQ(stateAt(-3.0), off);
}

TEST(UnderWaterHard, AViewThatTheSurfaceCutsHasNoSkyBelowWater) {
  struct Sea {
    const char* name;
    WaterSurface water;
  };
  const Sea seas[] = {{"still", test::stillSea()},
                      {"short", test::windSea(0.4, 3.0)},
                      {"storm", test::groupSea(9.0, 12.0)},
                      {"huge", test::groupSea(30.0, 18.0)}};
  // Not the naive grid, which ends 200 m away.
  auto ways = test::everyWay({64, 128});
  std::erase_if(ways, [](const test::Way& w) { return w.name == "naive_grid"; });
  for (const Sea& sea : seas) {
    for (const double off : {-0.04, 0.001, 0.04}) {
      for (const double pitch : {-20.0, 0.0, 15.0}) {
        Stage stage;
        stage.water = sea.water;
        stage.time = 3.0;
        const double height = sea.water.sample({3.0, 4.0}, 3.0).height;
        stage.camera = test::cameraAt({3, 4, height + off}, pitch, 0.0, 70.0, {24, 48});
        const Camera& camera = stage.camera;
        /// Of a pixel's point on the near plane over the water, m.
        const auto above = [&](int x, int y) {
          const glm::dvec3 ray = camera.rayThrough({x, y});
          const glm::dvec3 p =
              camera.position + ray * (camera.nearDistance / glm::dot(ray, camera.forward()));
          return p.z - sea.water.sample(glm::dvec2(p), 3.0).height;
        };
        EffectLedger effects;
        const View view = stage.view(effects);
        Waterline line;
        line.fill(view, true);
        for (const auto& way : ways) {
          const Frame frame = stage.draw(*way.technique);
          int gaps = 0, wrong = 0;
          for (int x = 0; x < 24; ++x) {
            bool water = false;
            for (int y = 0; y < 48; ++y) {
              const std::size_t i = static_cast<std::size_t>(y) * 24 + x;
              const double over = above(x, y);
              // Within the waterline's own error either side is right.
              wrong += std::abs(over) > 1e-4 && line.isUnder({x, y}) != (over < 0.0);
              if (frame.classes[i] == PixelClass::water && over > 1e-4) water = true;
              const bool sky = frame.classes[i] == PixelClass::sky;
              // The grid's own error, in mesh and map; what it leaves is drawn as water.
              const bool bright = test::brightness(frame, x, y) > 500;
              gaps += water && sky && over > 1e-4 && bright;
            }
          }
          EXPECT_EQ(gaps, 0) << sea.name << ", " << way.name << ", " << off << " m, " << pitch;
          EXPECT_EQ(wrong, 0) << sea.name << ", " << way.name << ", " << off << " m, " << pitch;
        }
      }
    }
  }
}

TEST(UnderWaterHard, ThingsThatCrossTheSurfaceAndEyesInsideThemDrawNumbers) {
  const Mesh mesh = test::boxMesh({-2, -1, -1}, {2, 1, 2}, glm::vec3(0.6f));
  Mesh one;
  one.parts.push_back({{{0, 0, -1}, {1, 0, 1}, {0, 1, 1}}, glm::vec3(0.5f)});
  one.boundingRadius = 1.5;
  const auto technique = makeSoftwareGrid({.grid = {48, 48}});
  for (const double height : {-6.0, -1.0, -1e-3, -1e-9, 0.0, 1e-3}) {
    for (const double pitch : {-89.0, 0.0, 40.0, 90.0}) {
      for (const double away : {0.0, 0.5, 3.0, 30.0, 30e3}) {
        Stage stage;
        stage.camera = test::cameraAt({0, 0, height}, pitch, 20.0, 90.0, {48, 40});
        stage.objects = {{&mesh, {away, 0.2, 0.3}, {1, 0, 0, 0}},
                         {&one, {away, -3.0, 0.0}, {1, 0, 0, 0}, 0, ObjectKind::scenery}};
        const Frame frame = stage.draw(*technique);
        for (const float d : frame.depth.metres) ASSERT_TRUE(d > 0.0f) << height << ' ' << pitch;
        ShadingConstants constants;
        EffectLedger effects;
        const View view = stage.view(effects);
        LocalLight local;
        local.fill(view, {.water = true, .cameraIsUnderWater = true, .anyUnderWater = true},
                   {shadingConstants(view, {})}, {});
        for (const LocalImage* image : {&local.window(), &local.depths()}) {
          for (const glm::vec4& t : image->texels) {
            ASSERT_TRUE(std::isfinite(t.x + t.y + t.z + t.w)) << height << ' ' << pitch;
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace seaway::render
