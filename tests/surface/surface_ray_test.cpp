#include "surface/surface_ray.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "surface/curvature.h"
#include "surface/fit/octave_fit.h"
#include "surface/spectra/families.h"

namespace seaway {
namespace {

WaterSurface stillSea() { return WaterSurface(WaveField({})); }
WaterSurface stormSea() {
  return WaterSurface(WaveField(fitGroupOctaves(jonswap({9.0, 13.0, 3.3})).octaves));
}

TEST(SurfaceRay, MeetsStillWaterWhereTheParaboloidIs) {
  const WaterSurface still = stillSea();
  for (const double slope : {0.01, 0.1, 1.0}) {
    const glm::dvec3 direction = glm::normalize(glm::dvec3(1.0, 0.0, -slope));
    // −slope·d + h = −d²/2R, nearer root.
    const double h = 5.0, r = earthMeanRadius;
    const double d = r * slope - std::sqrt(r * r * slope * slope - 2.0 * r * h);
    const auto found = distanceToWater(still.at(0.0), {10.0, 20.0, h}, direction);
    ASSERT_TRUE(found);
    EXPECT_NEAR(*found * direction.x, d, 2e-4 + 1e-9 * d);  // the default tolerance along the ray
  }
}

TEST(SurfaceRay, InTheSeaPlaneTheSeaIsFlat) {
  const WaterSurface still = stillSea();
  const glm::dvec3 direction = glm::normalize(glm::dvec3(1.0, 0.0, -0.001));
  const auto found = distanceToWater(still.at(0.0), {0, 0, 5}, direction, {.curved = false});
  ASSERT_TRUE(found);
  EXPECT_NEAR(*found * direction.x, 5000.0, 1e-3);
}

TEST(SurfaceRay, RaysAboveTheHorizonMeetNoWater) {
  const WaterSurface still = stillSea();
  const double dip = std::sqrt(2.0 * 5.0 / earthMeanRadius);
  EXPECT_FALSE(distanceToWater(still.at(0.0), {0, 0, 5}, glm::normalize(glm::dvec3(1, 0, 0.1))));
  EXPECT_FALSE(
      distanceToWater(still.at(0.0), {0, 0, 5}, glm::normalize(glm::dvec3(1, 0, -0.99 * dip))));
  EXPECT_TRUE(
      distanceToWater(still.at(0.0), {0, 0, 5}, glm::normalize(glm::dvec3(1, 0, -1.01 * dip))));
}

TEST(SurfaceRay, PointsFoundLieOnTheSurfaceSeenFromAboveAndFromBelow) {
  const WaterSurface storm = stormSea();
  for (int i = 0; i < 60; ++i) {
    const double pitch = -0.02 - 0.02 * (i / 2), side = i % 2 ? 1.0 : -1.0;
    const glm::dvec3 origin(13.0 * i, 5.0, side > 0 ? 14.0 : -14.0);
    const glm::dvec3 direction =
        glm::normalize(glm::dvec3(std::cos(0.3 * i), std::sin(0.3 * i), side * std::tan(pitch)));
    const auto found = distanceToWater(storm.at(2.0), origin, direction);
    ASSERT_TRUE(found) << i;
    const glm::dvec3 p = origin + direction * *found;
    const double level = glm::distance(glm::dvec2(p), glm::dvec2(origin));
    // Tolerance 1e-4 m along the ray, slopes below 1.
    EXPECT_NEAR(p.z + seaDrop(level), storm.sample(glm::dvec2(p), 2.0).height, 3e-4) << i;
  }
}

TEST(SurfaceRay, NoWaterLiesBeforeTheFirstPointFound) {
  const WaterSurface storm = stormSea();
  for (int i = 0; i < 40; ++i) {
    const glm::dvec3 origin(0.0, 50.0 * i, 13.0);
    const glm::dvec3 direction = glm::normalize(glm::dvec3(1.0, 0.2, -0.015 * (i + 1)));
    const auto found = distanceToWater(storm.at(0.0), origin, direction);
    ASSERT_TRUE(found);
    for (int k = 1; k < 2000; ++k) {
      const double distance = 0.1 + (*found - 0.1) * k / 2000.0;
      const glm::dvec3 p = origin + direction * distance;
      const double level = glm::distance(glm::dvec2(p), glm::dvec2(origin));
      ASSERT_GE(p.z + seaDrop(level) - storm.sample(glm::dvec2(p), 0.0).height, -1e-3)
          << i << ' ' << distance << " of " << *found;
    }
  }
}

TEST(SurfaceRayHard, RaysThatAreNotFiniteMeetNothing) {
  const WaterSurface still = stillSea();
  EXPECT_FALSE(distanceToWater(still.at(0.0), {NAN, 0, 5}, {0, 0, -1}));
  EXPECT_FALSE(distanceToWater(still.at(0.0), {0, 0, 5}, {NAN, 0, -1}));
  EXPECT_FALSE(distanceToWater(still.at(NAN), {0, 0, 5}, {0, 0, -1}));
}

}  // namespace
}  // namespace seaway
