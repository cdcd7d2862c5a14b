#include "sim_bridge/mujoco/added_inertia.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "sim_bridge/dynamics/hull_vessel.h"
#include "tests/sim_bridge/mujoco/afloat.h"

namespace seaway::bridge::test {
namespace {

HullCoefficients withAddedMass(const std::array<double, 6>& parts) {
  HullCoefficients coefficients = ideal();
  coefficients.addedMass = parts;
  return coefficients;
}

double heaveTheory(double part) {
  return std::sqrt(seaWaterDensity * standardGravity * length * beam / ((1.0 + part) * boxMass()));
}

// Added mass falls with the volume under water as the box rises, on that half of the swing alone:
// 2 mm of 100 make half a percent of the frequency at most.
TEST(MujocoAddedMass, SlowsHeaveToTheFrequencyOfMassAndWater) {
  for (const double part : {0.3, 1.0, 3.0}) {
    for (const char* joint : {free, heaving}) {
      Afloat body(box(), boxMass(), withAddedMass({0.05, 0.8, part, 0.2, 0.8, 0.5}), joint,
                  WaveField({}), 0.01);
      body.mujoco->data->qpos[joint == free ? 2 : 0] = 0.002;
      const double found = frequencyOf(body, 20.0, [&] { return body.height(); });
      EXPECT_NEAR(found, heaveTheory(part), 0.01 * heaveTheory(part))
          << part << ' ' << joint << ' ' << found / heaveTheory(part) - 1.0;
    }
  }
}

TEST(MujocoAddedMass, SlowsRollLikewise) {
  const double part = 0.5;
  Afloat still(box(), boxMass(), ideal(), free, WaveField({}), 0.01);
  Afloat body(box(), boxMass(), withAddedMass({0.0, 0.0, 0.0, part, 0.0, 0.0}), free, WaveField({}),
              0.01);
  for (Afloat* each : {&still, &body}) each->mujoco->data->qpos[4] = 0.02;
  const auto roll = [](Afloat& each) { return [&] { return each.mujoco->data->qpos[4]; }; };
  const double bare = frequencyOf(still, 30.0, roll(still));
  const double slowed = frequencyOf(body, 30.0, roll(body));
  EXPECT_NEAR(slowed * std::sqrt(1.0 + part), bare, 0.01 * bare);
}

// Both integrate Kirchhoff's equations: MuJoCo by Runge and Kutta's fourth order, HullVessel by
// semi-implicit Euler in steps of a millisecond, which is first order.
TEST(MujocoAddedMass, TumblingHullsMoveAsTheReferenceVesselDoes) {
  HullCoefficients coefficients = withAddedMass({0.05, 0.8, 1.0, 0.2, 0.8, 0.5});
  coefficients.formDrag = 0.5;
  Afloat body(box(), boxMass(), coefficients, free, WaveField({}), 0.002);
  HullVessel vessel(body.hull);
  RigidMotion motion = vessel.motion();
  motion.velocity = {1.0, 0.4, 0.0};
  motion.turning = {0.3, 0.2, 0.8};
  vessel.setMotion(motion);
  mjData* data = body.mujoco->data.get();
  const HullPose pose = vessel.pose();
  for (int i = 0; i < 3; ++i) {
    data->qpos[i] = pose.position[i];
    data->qvel[i] = pose.velocity[i];
    data->qvel[3 + i] = motion.turning[i];
  }
  while (body.time() < 2.0 - 1e-6) body.step();
  for (int i = 1; i <= 2000; ++i) vessel.advance(0.001 * i, body.water);
  const HullPose end = vessel.pose();
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(data->qpos[i], end.position[i], 5e-3) << i;
  const glm::dquat turn(data->qpos[3], data->qpos[4], data->qpos[5], data->qpos[6]);
  EXPECT_GT(std::abs(glm::dot(turn, end.worldFromBody)), std::cos(0.01));
}

// What an explicit force −A a could not do: water ten times the body's mass at a long step. The
// swing may grow while A changes with the volume under water (2 % of it here), not from step to
// step.
TEST(MujocoAddedMassHard, TenTimesTheMassIsStable) {
  Afloat body(box(), boxMass(), withAddedMass({10.0, 10.0, 10.0, 10.0, 10.0, 10.0}), free,
              WaveField({}), 0.05);
  body.mujoco->data->qpos[2] = 0.002;
  double early = 0.0, late = 0.0;
  while (body.time() < 100.0) {
    body.step();
    double& largest = body.time() < 50.0 ? early : late;
    largest = std::max(largest, std::abs(body.height()));
  }
  EXPECT_LE(late, 1.02 * 0.002);
  EXPECT_GT(late, 0.9 * early);
}

// mj_forwardSkip leaves positions and M as they are and calls for passive forces again.
TEST(MujocoAddedMass, RepeatedEvaluationsCountItOnce) {
  Afloat body(box(), boxMass(), withAddedMass({0.0, 0.0, 1.0, 0.0, 0.0, 0.0}), free, WaveField({}),
              0.01);
  body.mujoco->data->qpos[2] = 0.01;
  mj_forward(body.mujoco->model.get(), body.mujoco->data.get());
  const double once = body.mujoco->data->qacc[2];
  for (int i = 0; i < 3; ++i) {
    mj_forwardSkip(body.mujoco->model.get(), body.mujoco->data.get(), mjSTAGE_POS, 1);
  }
  EXPECT_EQ(body.mujoco->data->qacc[2], once);
}

}  // namespace
}  // namespace seaway::bridge::test
