#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "surface/disturbance/layers/surface_layer.h"
#include "tests/support/allocation_counter.h"
#include "tests/surface/hull/hull_cases.h"

namespace seaway {
namespace {

using namespace test;

/// Still water that something fell into at the origin at time 0: rings of 4 m.
WaterSurface splashed() {
  WaterSurface water{WaveField({})};
  const std::vector<Splash> splashes{Splash{.place = {0.0, 0.0},
                                            .time = 0.0,
                                            .height = 0.1,
                                            .wavelength = 4.0,
                                            .reach = 20.0,
                                            .duration = 8.0}};
  water.setEvents(std::make_shared<SurfaceEvents>(splashes, Rain{}, SurfaceEvents::Water{}));
  return water;
}

HullModel smallBox(LoadLevel level) {
  HullSettings settings;
  settings.level = level;
  settings.mass = 0.5 * seaWaterDensity * 0.3 * 0.3 * 0.2;
  settings.columns = {6, 6};
  return {boxMesh(0.3, 0.3, 0.2, 0.1, 200), settings};
}

// 0.3 m are a thirteenth of the ring: the lift is that of the height over the middle within 10 %.
// With pressure below the surface it is that at the keel: less by e^(−πd), d deep.
TEST(DisturbedHulls, FeelSplashesAsTheirSurfaceStands) {
  const WaterSurface water = splashed();
  LoadScratch scratch;
  for (const LoadLevel level : {LoadLevel::columns, LoadLevel::mesh, LoadLevel::meshDynamic}) {
    const HullModel hull = smallBox(level);
    int felt = 0;
    for (double t = 0.5; t < 6.0; t += 0.1) {
      HullPose pose;
      pose.position = {3.0, 1.0, 0.0};
      const double surface = water.sample({3.0, 1.0}, t).height;
      if (std::abs(surface) < 0.004 || std::abs(surface) > 0.016) continue;
      ++felt;
      const double lift = loads(hull, pose, water, t, scratch).buoyancy.force.z -
                          hull.settings().mass * standardGravity;
      const double kept = level == LoadLevel::meshDynamic ? std::exp(-pi * (0.1 + surface)) : 1.0;
      EXPECT_NEAR(lift / (weightDensity * 0.09 * surface), kept, 0.1)
          << static_cast<int>(level) << " at " << t;
    }
    EXPECT_GT(felt, 3);
  }
}

TEST(DisturbedHulls, OilTakesShortWavesFromUnderSmallHulls) {
  WaterSurface rough{WaveField({makeRegularWave(0.02, 1.25, 0.0)})};  // λ = 1 m
  WaterSurface oiled = rough;
  auto detail = std::make_shared<SurfaceDetail>();
  auto oil = std::make_shared<SurfaceLayer>(LayerSettings{.cellSize = 0.5, .decayTime = INFINITY});
  oil->paint({-20.0, -20.0}, {20.0, 20.0}, 0.0, [](glm::dvec2) { return 1.0f; });
  detail->cover.oil = oil;
  oiled.setDetail(detail);
  const HullModel hull = smallBox(LoadLevel::meshDynamic);
  LoadScratch scratch;
  double largestRough = 0.0, largestOiled = 0.0;
  const double weight = hull.settings().mass * standardGravity;
  for (double t = 0.0; t < 1.0; t += 0.05) {
    const auto lift = [&](const WaterSurface& water) {
      return std::abs(loads(hull, {}, water, t, scratch).buoyancy.force.z - weight);
    };
    largestRough = std::max(largestRough, lift(rough));
    largestOiled = std::max(largestOiled, lift(oiled));
  }
  EXPECT_GT(largestRough, 0.05 * weight);
  // At the surface nothing is left; what pressure the octave has below is taken away by its height.
  EXPECT_LT(largestOiled, 0.35 * largestRough);
}

TEST(DisturbedHulls, TellShoresAndFloatOnAsIfThereWereNone) {
  WaterSurface water{WaveField({})};
  const std::array lake{
      OutlinePolygon{{{{-50.0, -50.0}, {1.0, -50.0}, {1.0, 50.0}, {-50.0, 50.0}}}}};
  water.setOutline(std::make_shared<WaterOutline>(lake));
  const HullModel hull = halfFloating(boxMesh(4.0, 2.0, 1.0, 0.5));
  LoadScratch scratch;
  HullPose pose;
  const double weight = hull.settings().mass * standardGravity;
  for (const double x : {-20.0, 0.0}) {
    pose.position.x = x;
    const HullLoads load = loads(hull, pose, water, 0.0, scratch);
    EXPECT_EQ(has(load.status, SampleStatus::dry), x == 0.0);
    EXPECT_NEAR(load.total().force.z, weight, 1e-9 * weight);
    EXPECT_NEAR(load.total().force.x, 0.0, 1e-9 * weight);
  }
}

TEST(DisturbedHulls, TellTheBedUnderTheirKeel) {
  const WaterSurface shallow{WaveField({}, {.depth = 0.6})};
  LoadScratch scratch;
  for (const LoadLevel level : {LoadLevel::columns, LoadLevel::mesh, LoadLevel::meshDynamic}) {
    const HullModel hull = halfFloating(boxMesh(4.0, 2.0, 1.0, 0.5), level);
    HullPose pose;
    const HullLoads afloat = loads(hull, pose, shallow, 0.0, scratch);
    EXPECT_FALSE(has(afloat.status, SampleStatus::belowBed));
    pose.position.z = -0.2;
    const HullLoads touching = loads(hull, pose, shallow, 0.0, scratch);
    EXPECT_TRUE(has(touching.status, SampleStatus::belowBed));
    EXPECT_GT(touching.total().force.z, afloat.total().force.z);
  }
}

TEST(DisturbedHulls, AllocateNothingOnceWarm) {
  const WaterSurface water = splashed();
  const HullModel hull = smallBox(LoadLevel::meshDynamic);
  LoadScratch scratch;
  double sum = loads(hull, {}, water, 1.0, scratch).buoyancy.force.z;
  const std::size_t before = test_support::allocationCount();
  for (int i = 0; i < 20; ++i) sum += loads(hull, {}, water, 0.1 * i, scratch).buoyancy.force.z;
  EXPECT_EQ(test_support::allocationCount(), before);
  EXPECT_GT(sum, 0.0);
}

}  // namespace
}  // namespace seaway
