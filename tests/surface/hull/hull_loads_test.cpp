#include "surface/hull/hull_loads.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "tests/support/allocation_counter.h"
#include "tests/surface/hull/hull_cases.h"

namespace seaway {
namespace {

using namespace test;

// Sums of 800 rounded terms of some 30 times the result: 1e-13. The mesh's own volume is exact.
TEST(HullLoads, SubmergedHullsFeelTheirDisplacementUpwardsAndNoTorqueAtAnyAttitude) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> depth(2.0, 30.0);
  LoadScratch scratch;
  for (const TriangleMesh& mesh : {wigleyMesh(2.0, 0.4, 0.2, 0.1), boxMesh(1.0, 0.5, 0.4, 0.2)}) {
    const HullModel hull = halfFloating(mesh);
    const MassProperties whole = massProperties(mesh);
    const double weight = weightDensity * whole.volume;
    for (int i = 0; i < 500; ++i) {
      HullPose pose;
      pose.worldFromBody = randomAttitude(random);
      pose.position = {100.0, -50.0, -depth(random)};
      const HullLoads load = loads(hull, pose, stillWater(), 0.0, scratch);
      const glm::dvec3 error = load.total().force - glm::dvec3(0.0, 0.0, weight);
      ASSERT_LT(glm::length(error), 1e-9 * weight);
      const glm::dvec3 arm = pose.worldFromBody * whole.centroid;
      const glm::dvec3 torque = load.total().moment - glm::cross(arm, load.total().force);
      ASSERT_LT(glm::length(torque), 1e-9 * weight * hull.length());
      ASSERT_NEAR(load.submergedVolume, whole.volume, 1e-9 * whole.volume);
      ASSERT_NEAR(load.wettedArea, whole.area, 1e-9 * whole.area);
    }
  }
}

TEST(HullLoads, AgreeWithHydrostaticsAtAnyDraftAndAttitude) {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> height(-0.3, 0.3);
  const TriangleMesh mesh = wigleyMesh(2.0, 0.4, 0.2, 0.1);
  const HullModel hull = halfFloating(mesh);
  const double weight = weightDensity * massProperties(mesh).volume;
  LoadScratch scratch;
  for (int i = 0; i < 300; ++i) {
    HullPose pose;
    pose.worldFromBody = randomAttitude(random);
    pose.position.z = height(random);
    const HullLoads load = loads(hull, pose, stillWater(), 0.0, scratch);
    const glm::dvec3 up = glm::inverse(pose.worldFromBody) * glm::dvec3(0.0, 0.0, 1.0);
    const SubmergedPart part = submergedPart(mesh, {up, -pose.position.z});
    const glm::dvec3 force(0.0, 0.0, weightDensity * part.volume);
    ASSERT_LT(glm::length(load.total().force - force), 1e-9 * weight);
    const glm::dvec3 moment = glm::cross(pose.worldFromBody * part.centre, force);
    ASSERT_LT(glm::length(load.total().moment - moment), 1e-9 * weight * hull.length());
    ASSERT_NEAR(load.submergedVolume, part.volume, 1e-9 * part.volume + 1e-15);
    ASSERT_NEAR(load.wettedArea, part.wettedArea, 1e-9 * hull.length());
  }
}

// A closed path through every kind of wetness. The trapezium rule on a smooth periodic integrand
// converges at once; kinks where vertices pass the surface leave O(h³): 1e-7 at 20 000 steps.
TEST(HullLoads, StillWaterDoesNoWorkAroundAClosedPath) {
  const HullModel hull = halfFloating(wigleyMesh(2.0, 0.4, 0.2, 0.1, 400));
  LoadScratch scratch;
  const int steps = 20000;
  const auto poseAt = [](double s) {
    const double a = 2.0 * pi * s;
    HullPose pose;
    pose.position = {std::cos(a), std::sin(2.0 * a), 0.25 * std::sin(a) + 0.05};
    pose.worldFromBody = glm::angleAxis(0.8 * std::sin(a), glm::dvec3(1.0, 0.0, 0.0)) *
                         glm::angleAxis(0.5 * std::cos(2.0 * a), glm::dvec3(0.0, 1.0, 0.0)) *
                         glm::angleAxis(a, glm::dvec3(0.0, 0.0, 1.0));
    return pose;
  };
  double work = 0.0, passed = 0.0;
  const double h = 1.0 / steps;
  for (int i = 0; i < steps; ++i) {
    const double s = (i + 0.5) * h;
    const HullPose before = poseAt(s - 0.01 * h), after = poseAt(s + 0.01 * h);
    // Velocities by a narrow central difference: relative 1e-9.
    const glm::dvec3 velocity = (after.position - before.position) / (0.02 * h);
    const glm::dquat turn = after.worldFromBody * glm::inverse(before.worldFromBody);
    const glm::dvec3 turning = 2.0 * glm::dvec3(turn.x, turn.y, turn.z) / (0.02 * h);
    const Load load = loads(hull, poseAt(s), stillWater(), 0.0, scratch).buoyancy;
    const double power = glm::dot(load.force, velocity) + glm::dot(load.moment, turning);
    work += power * h;
    passed += std::abs(power) * h;
  }
  EXPECT_LT(std::abs(work), 1e-6 * passed);
}

TEST(HullLoads, CalibratedHullsDisplaceWhatIsKnownAtDesignAndOtherDrafts) {
  const double l = 10.0, b = 1.0, t = 0.625, exact = 4.0 / 9.0 * l * b * t;
  const TriangleMesh mesh = wigleyMesh(l, b, t, 0.4, 800);
  HullSettings settings;
  settings.mass = seaWaterDensity * exact;
  settings.centreOfGravity.z = -0.3;
  settings.knownVolume = exact;
  const HullModel hull(mesh, settings);
  EXPECT_NEAR(hull.restHeight(), 0.0, 5e-4 * t);
  LoadScratch scratch;
  for (const double draft : {t, 0.9 * t, 0.8 * t}) {
    HullPose pose;
    pose.position.z = t - draft;
    const double s = 1.0 - draft / t;
    // ∫ from −1 to −s of (1 − z²) dz.
    const double volume = 2.0 / 3.0 * l * b * t * (2.0 / 3.0 - s + s * s * s / 3.0);
    const double found = loads(hull, pose, stillWater(), 0.0, scratch).submergedVolume;
    EXPECT_NEAR(found, volume, (s > 0.0 ? 2e-3 : 5e-4) * volume)
        << draft << ": off by " << 100.0 * (found / volume - 1.0) << " %";
  }
}

TEST(HullLoads, GiveTheSameBitsAloneTogetherAndFromAnyScratch) {
  const WaterSurface sea = groups(12);
  const HullModel mesh = halfFloating(wigleyMesh(10.0, 1.5, 0.6, 0.5, 300));
  const HullModel columns = halfFloating(boxMesh(4.0, 2.0, 1.0, 0.5), LoadLevel::columns);
  std::vector<PlacedHull> hulls;
  for (int i = 0; i < 40; ++i) {
    HullPose pose;
    pose.position = {17.0 * i, -5.0 * i, 0.0};
    pose.velocity = {0.1 * i, 1.0, 0.0};
    hulls.push_back({i % 2 ? &mesh : &columns, pose, {}});
  }
  const SurfaceAtTime now = sea.at(3.0);
  std::vector<HullLoads> together(hulls.size());
  std::vector<LoadScratch> scratch(hulls.size());
  loadsInParallel(hulls, now, together, scratch);
  LoadScratch one;
  for (std::size_t i = 0; i < hulls.size(); ++i) {
    const HullLoads alone = loads(*hulls[i].model, hulls[i].pose, sea, 3.0, one);
    EXPECT_EQ(alone.total().force, together[i].total().force);
    EXPECT_EQ(alone.total().moment, together[i].total().moment);
  }
}

TEST(HullLoads, AllocateNothingOnceWarm) {
  const WaterSurface sea = groups(12);
  const HullModel mesh = halfFloating(wigleyMesh(10.0, 1.5, 0.6, 0.5));
  const HullModel columns = halfFloating(boxMesh(4.0, 2.0, 1.0, 0.5), LoadLevel::columns);
  LoadScratch scratch;
  for (const HullModel* hull : {&mesh, &columns}) {
    HullPose pose;
    pose.velocity.x = 1.0;
    double sum = loads(*hull, pose, sea, 0.0, scratch).buoyancy.force.z;
    const std::size_t before = test_support::allocationCount();
    for (int i = 1; i < 20; ++i) {
      pose.position.z = 0.1 * i - 1.0;
      sum += loads(*hull, pose, sea, 0.1 * i, scratch).buoyancy.force.z;
    }
    EXPECT_EQ(test_support::allocationCount(), before);
    EXPECT_GT(sum, 0.0);
  }
}

}  // namespace
}  // namespace seaway
