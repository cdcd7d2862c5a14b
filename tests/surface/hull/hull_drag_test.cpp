#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "surface/hull/hull_loads.h"
#include "tests/surface/hull/hull_cases.h"

namespace seaway {
namespace {

using namespace test;

TEST(HullLoads, DragOpposesMotionThroughTheWaterAndCarriesWithTheCurrent) {
  const TriangleMesh mesh = wigleyMesh(10.0, 1.5, 0.6, 0.5);
  const HullModel hull = halfFloating(mesh);
  LoadScratch scratch;
  std::mt19937_64 random(6);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 100; ++i) {
    HullPose pose;
    pose.position.z = hull.restHeight();
    pose.velocity = {normal(random), normal(random), normal(random)};
    pose.angularVelocity = {normal(random), normal(random), normal(random)};
    const HullLoads load = loads(hull, pose, stillWater(), 0.0, scratch);
    const Load lost{load.drag.force + load.radiation.force,
                    load.drag.moment + load.radiation.moment};
    EXPECT_LT(glm::dot(lost.force, pose.velocity) + glm::dot(lost.moment, pose.angularVelocity),
              0.0);
  }
  const WaterSurface stream{WaveField({}, {.current = {1.5, -0.5}})};
  HullPose drifting;
  drifting.position.z = hull.restHeight();
  drifting.velocity = {1.5, -0.5, 0.0};
  EXPECT_NEAR(glm::length(loads(hull, drifting, stream, 0.0, scratch).drag.force), 0.0, 1e-9);
  drifting.velocity = {};
  EXPECT_GT(loads(hull, drifting, stream, 0.0, scratch).drag.force.x, 0.0);
}

// A plate of area A across the flow has C_D = 2C; the ITTC line at Re = 1e7 is 0.003.
TEST(HullLoads, PlatesHaveTheDragTheirCoefficientsState) {
  const TriangleMesh plate = moved(boxMesh(0.002, 1.0, 1.0, 0.5), {0.0, 0.0, 0.0});
  HullSettings settings;
  settings.mass = 0.5 * seaWaterDensity * 0.002;
  settings.coefficients.formDrag = 0.6;
  settings.coefficients.skinFriction = 0.0;
  settings.coefficients.heaveDamping = 0.0;
  LoadScratch scratch;
  HullPose pose;
  pose.position.z = -3.0;
  pose.velocity = {2.0, 0.0, 0.0};
  const HullModel across(plate, settings);
  EXPECT_NEAR(loads(across, pose, stillWater(), 0.0, scratch).drag.force.x,
              -0.5 * seaWaterDensity * 1.2 * 4.0, 1e-6);
  settings.coefficients.skinFriction.reset();
  const HullModel skin(plate, settings);
  pose.velocity = {0.0, 0.0, 2.0};
  const double reynolds = 2.0 * 0.002 / 1.19e-6;
  const double friction = 0.075 / std::pow(std::log10(reynolds) - 2.0, 2);
  EXPECT_NEAR(loads(skin, pose, stillWater(), 0.0, scratch).drag.force.z,
              -0.5 * seaWaterDensity * 4.0 * (friction * 2.004 + 1.2 * 0.002), 0.01);
}

TEST(HullLoads, WindPushesWhatIsOutOfTheWater) {
  const TriangleMesh mesh = boxMesh(2.0, 1.0, 1.0, 0.5);
  const HullModel hull = halfFloating(mesh);
  LoadScratch scratch;
  const HullLoads load =
      loads(hull, {}, stillWater(), 0.0, scratch, {.wind = glm::dvec2(0.0, 10.0)});
  EXPECT_NEAR(load.wind.force.y, 0.5 * airDensity * 1.0 * 100.0 * 2.0 * 0.5, 1e-6);
  EXPECT_NEAR(load.wind.moment.x, -0.25 * load.wind.force.y, 1e-6);
  EXPECT_EQ(loads(hull, {}, stillWater(), 0.0, scratch).wind.force.y, 0.0);
}

TEST(HullLoads, SlammingIsOffUnlessAskedForAndResistsEntry) {
  HullSettings settings;
  settings.mass = 100.0;
  HullPose pose;
  pose.position.z = 0.45;
  pose.velocity.z = -3.0;
  LoadScratch scratch;
  const TriangleMesh mesh = sphereMesh(0.5);
  const double without =
      loads(HullModel(mesh, settings), pose, stillWater(), 0.0, scratch).drag.force.z;
  settings.coefficients.slamming = 5.0;
  const HullModel slams(mesh, settings);
  EXPECT_GT(loads(slams, pose, stillWater(), 0.0, scratch).drag.force.z, 1.2 * without);
  pose.velocity.z = 3.0;
  EXPECT_NEAR(loads(slams, pose, stillWater(), 0.0, scratch).drag.force.z, -without,
              1e-9 * without);
}

}  // namespace
}  // namespace seaway
