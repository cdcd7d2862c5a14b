#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "surface/hull/hull_loads.h"
#include "surface/input_error.h"
#include "tests/surface/hull/hull_cases.h"

namespace seaway {
namespace {

using namespace test;

TEST(HullLoadsHard, PosesAndTimesThatAreNotFiniteGiveNanAndAStatus) {
  const HullModel hull = halfFloating(boxMesh(1.0, 1.0, 1.0, 0.5));
  const WaterSurface sea = groups(3);
  LoadScratch scratch;
  HullPose pose;
  pose.position.x = std::numeric_limits<double>::quiet_NaN();
  const HullLoads lost = loads(hull, pose, sea, 0.0, scratch);
  EXPECT_TRUE(std::isnan(lost.total().force.x));
  EXPECT_TRUE(has(lost.status, SampleStatus::notFinite));
  EXPECT_TRUE(std::isnan(loads(hull, {}, sea, NAN, scratch).total().force.z));
  pose.position.x = 1e13;
  EXPECT_TRUE(has(loads(hull, pose, sea, 0.0, scratch).status, SampleStatus::outOfRange));
  // And comes back.
  EXPECT_TRUE(std::isfinite(loads(hull, {}, sea, 0.0, scratch).total().force.z));
}

TEST(HullLoadsHard, HullsOutOfTheWaterFeelNothingAndUnderItTheirDisplacement) {
  const HullModel hull = halfFloating(sphereMesh(1.0));
  const WaterSurface sea = groups(6);
  LoadScratch scratch;
  HullPose pose;
  pose.position.z = 30.0;
  const HullLoads out = loads(hull, pose, sea, 2.0, scratch);
  EXPECT_EQ(out.total().force, glm::dvec3(0.0));
  EXPECT_EQ(out.submergedVolume, 0.0);
  pose.position.z = -60.0;
  const HullLoads under = loads(hull, pose, sea, 2.0, scratch);
  // What the longest wave (156 m) leaves at 60 m depth is k a e^(−kd) of the weight: 0.2 %.
  EXPECT_NEAR(under.buoyancy.force.z, weightDensity * 4.0 / 3.0 * pi,
              2e-3 * weightDensity * 4.0 / 3.0 * pi);
}

TEST(HullLoadsHard, PerlinSeasAndShallowTroughsAreTold) {
  const HullModel hull = halfFloating(boxMesh(1.0, 1.0, 1.0, 0.5));
  LoadScratch scratch;
  const WaterSurface perlin{WaveField({makePerlinOctave(0.3, 40.0, 0.0)})};
  const HullLoads hydrostatic = loads(hull, {}, perlin, 0.0, scratch);
  EXPECT_TRUE(has(hydrostatic.status, SampleStatus::noKinematics));
  EXPECT_TRUE(std::isfinite(hydrostatic.total().force.z));
  const WaterSurface dry{WaveField({makeRegularWave(2.0, 0.1, 0.0, pi, 1.0)}, {.depth = 1.0})};
  const HullLoads aground = loads(hull, {}, dry, 0.0, scratch);
  EXPECT_TRUE(has(aground.status, SampleStatus::belowBed));
  EXPECT_TRUE(std::isnan(aground.total().force.z));
}

TEST(HullLoadsHard, ThinPlatesCubesOfAMillimetreAndTankersKeepArchimedes) {
  LoadScratch scratch;
  for (const glm::dvec3 size :
       {glm::dvec3(2.0, 1.0, 1e-3), glm::dvec3(1e-3), glm::dvec3(400.0, 60.0, 30.0)}) {
    const TriangleMesh mesh = boxMesh(size.x, size.y, size.z, 0.5 * size.z);
    for (const double part : {0.01, 0.5, 0.99}) {
      const double mass = part * seaWaterDensity * size.x * size.y * size.z;
      const HullModel hull = model(mesh, mass);
      HullPose pose;
      pose.position.z = hull.restHeight();
      EXPECT_NEAR(hull.restHeight(), (0.5 - part) * size.z, 1e-9 * size.z);
      EXPECT_NEAR(loads(hull, pose, stillWater(), 0.0, scratch).total().force.z,
                  mass * standardGravity, 1e-9 * mass * standardGravity);
    }
  }
}

TEST(HullModelHard, BadMeshesAndMassesAreRefusedWithTheirReason) {
  TriangleMesh mesh = boxMesh(1.0, 1.0, 1.0, 0.5);
  for (const double mass : {0.0, -1.0, 2000.0, static_cast<double>(NAN)}) {
    EXPECT_THROW(model(mesh, mass), InputError) << mass;
  }
  // Turned round without a word: which way is out is not in doubt.
  EXPECT_GT(model(turnedInsideOut(mesh), 500.0).atRest().volume, 0.0);
  TriangleMesh flipped = mesh;
  std::swap(flipped.triangles[3].x, flipped.triangles[3].y);
  EXPECT_THROW(model(flipped, 500.0), InputError);
  mesh.triangles.pop_back();
  try {
    model(mesh, 500.0);
    FAIL();
  } catch (const InputError& fault) {
    EXPECT_NE(std::string(fault.what()).find("hole"), std::string::npos);
  }
}

}  // namespace
}  // namespace seaway
