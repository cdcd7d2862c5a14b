#include "sim_bridge/mujoco/hull_coupling.h"

#include <gtest/gtest.h>

#include <cmath>

#include "surface/hull/analytic_hulls.h"
#include "surface/input_error.h"
#include "tests/sim_bridge/mujoco/afloat.h"

namespace seaway::bridge::test {
namespace {

TEST(MujocoHulls, FreeBodiesFloatAtTheirTheoreticalDraft) {
  HullCoefficients damped;
  damped.heaveDamping = damped.rollDamping = damped.pitchDamping = 0.7;
  const double r = 0.5;
  struct Case {
    TriangleMesh mesh;
    double mass, height;  // of the origin at rest
  };
  for (const Case& each :
       {Case{box(), boxMass(), 0.0},
        Case{sphereMesh(r), seaWaterDensity * 2.0 / 3.0 * pi * r * r * r, 0.0},
        Case{sparMesh(0.3, 1.0, 0.4), seaWaterDensity * pi / 4.0 * 0.09 * 0.8, 0.2}}) {
    Afloat body(each.mesh, each.mass, damped, heaving, WaveField({}), 0.01);
    body.mujoco->data->qpos[0] = each.height + 0.05;
    while (body.time() < 20.0) body.step();
    const double keel = -boundsOf(each.mesh).lower.z;
    EXPECT_NEAR(keel - body.height(), keel - each.height, 1e-3 * (keel - each.height));
  }
  Afloat released(box(), boxMass(), damped, free, WaveField({}), 0.01);
  released.mujoco->data->qpos[2] = 0.05;
  while (released.time() < 20.0) released.step();
  EXPECT_NEAR(draft - released.height(), draft, 1e-3 * draft);
  EXPECT_NEAR(std::abs(released.mujoco->data->qpos[3]), 1.0, 1e-6);  // upright
}

TEST(MujocoHulls, HeaveDecaysAtTheFrequencyOfTheWaterplane) {
  Afloat body(box(), boxMass(), ideal(), free, WaveField({}), 0.01);
  body.mujoco->data->qpos[2] = 0.01;
  const double theory = std::sqrt(seaWaterDensity * standardGravity * length * beam / boxMass());
  const double found = frequencyOf(body, 10.0, [&] { return body.height(); });
  EXPECT_NEAR(found, theory, 0.01 * theory) << found / theory - 1.0;
}

TEST(MujocoHulls, RollDecaysAtTheFrequencyOfTheMetacentricHeight) {
  Afloat body(box(), boxMass(), ideal(), free, WaveField({}), 0.01);
  const double angle = 0.01;
  body.mujoco->data->qpos[3] = std::cos(0.5 * angle);
  body.mujoco->data->qpos[4] = std::sin(0.5 * angle);
  const double gm = -0.5 * draft + beam * beam / (12.0 * draft) + 0.02;
  const double theory = std::sqrt(boxMass() * standardGravity * gm / body.inertia.x);
  const double found = frequencyOf(body, 20.0, [&] { return body.mujoco->data->qpos[4]; });
  EXPECT_NEAR(found, theory, 0.01 * theory) << found / theory - 1.0;
}

/// Heave of a box in a regular wave along x, from the steady state on, without damping.
struct Response {
  double amplitude, theory;
};
Response heaveResponse(double ratio, const char* joint = heaving) {
  const double k = 2.0 * pi / (ratio * length), omega = std::sqrt(standardGravity * k);
  const double a = 1e-3;
  const double natural = std::sqrt(standardGravity / draft);
  const double theory = a * std::exp(-k * draft) * std::sin(0.5 * k * length) / (0.5 * k * length) /
                        (1.0 - omega * omega / (natural * natural));
  const double period = 2.0 * pi / omega;
  Afloat body(box(1500), boxMass(), ideal(), joint,
              WaveField({makeRegularWave(a, omega / (2.0 * pi), 0.0)}), period / 80.0);
  body.mujoco->data->qpos[joint == heaving ? 0 : 2] = theory;
  mj_forward(body.mujoco->model.get(), body.mujoco->data.get());
  double inPhase = 0.0, outOfPhase = 0.0;
  for (int i = 0; i < 240; ++i) {
    inPhase += body.height() * std::cos(omega * body.time()) / 120.0;
    outOfPhase += body.height() * std::sin(omega * body.time()) / 120.0;
    body.step();
  }
  return {std::hypot(inPhase, outOfPhase), std::abs(theory)};
}

TEST(MujocoHulls, SmallBoxesHeaveInRegularWavesAsFroudeAndKrylovHaveIt) {
  for (const double ratio : {2.0, 3.0, 5.0, 10.0, 20.0}) {
    const Response response = heaveResponse(ratio);
    EXPECT_NEAR(response.amplitude, response.theory, 0.03 * response.theory)
        << "wavelength " << ratio << " L: " << response.amplitude / response.theory - 1.0;
  }
}

TEST(MujocoHulls, BoxesAsLongAsTheWaveAreNotHeaved) {
  EXPECT_LT(heaveResponse(1.0).amplitude, 0.02 * 1e-3);
}

// λ = 25 L and more; free to move in all directions, with the damping of a real hull.
TEST(MujocoHulls, BodiesFollowLongWaves) {
  for (const double ratio : {25.0, 60.0}) {
    const double k = 2.0 * pi / (ratio * length), omega = std::sqrt(standardGravity * k);
    const double a = 0.02 * ratio * length / (2.0 * pi);
    Afloat body(box(), boxMass(), HullCoefficients{}, free,
                WaveField({makeRegularWave(a, omega / (2.0 * pi), 0.3)}), 0.01);
    body.mujoco->data->qpos[2] = a;
    double worst = 0.0;
    while (body.time() < 4.0 * pi / omega) {
      body.step();
      const glm::dvec2 place(body.mujoco->data->xpos[3], body.mujoco->data->xpos[4]);
      if (body.time() < 2.0 * pi / omega) continue;
      worst =
          std::max(worst, std::abs(body.height() - body.water.sample(place, body.time()).height));
    }
    EXPECT_LT(worst, 0.02 * a) << ratio;
  }
}

// RK4 with loads frozen at the step's start would be a first-order method; with the sea of every
// sub-stage's own time halving the step divides the error by 2⁴.
TEST(MujocoHulls, EverySubStageSeesTheSeaOfItsOwnTime) {
  const auto heightAfter = [](double step) {
    Afloat body(box(), boxMass(), ideal(), heaving, WaveField({makeRegularWave(1e-3, 0.5, 0.0)}),
                step);
    for (int i = 0; i < std::lround(1.6 / step); ++i) body.step();
    return body.height();
  };
  const double coarse = heightAfter(0.08), middle = heightAfter(0.04), fine = heightAfter(0.02);
  const double order = std::log2(std::abs((coarse - middle) / (middle - fine)));
  EXPECT_GT(order, 3.0);
}

TEST(MujocoHulls, ManyHullsMoveAsOneDoes) {
  const auto settle = [](int count) {
    std::string bodies;
    for (int i = 0; i < count; ++i) {
      bodies += "<body name='b" + std::to_string(i) +
                "' pos='0 0 0.03'><freejoint/><inertial pos='0 0 0' mass='" +
                std::to_string(boxMass()) + "' diaginertia='2 5 5'/></body>";
    }
    MujocoWorld many("<mujoco><option timestep='0.01' gravity='0 0 -9.80665'/><worldbody>" +
                     bodies + "</worldbody></mujoco>");
    HullSettings settings;
    settings.mass = boxMass();
    const auto hull = std::make_shared<HullModel>(box(), settings);
    const WaterSurface water(WaveField({makeRegularWave(0.1, 0.3, 0.0)}));
    HullCoupling coupling(*many.model, water);
    for (int i = 0; i < count; ++i) coupling.add("b" + std::to_string(i), hull);
    for (int i = 0; i < 200; ++i) mj_step(many.model.get(), many.data.get());
    return many.data->xpos[3 * count + 2];  // of the last
  };
  EXPECT_EQ(settle(1), settle(12));
}

TEST(MujocoHullsHard, UnknownBodiesAndSecondCouplingsAreRefused) {
  Afloat body(box(), boxMass(), ideal(), free, WaveField({}), 0.01);
  EXPECT_THROW(body.coupling->add("keel", body.hull), InputError);
  EXPECT_THROW(HullCoupling(*body.mujoco->model, body.water), std::logic_error);
  body.coupling.reset();
  EXPECT_EQ(mjcb_passive, nullptr);
}

TEST(MujocoHullsHard, CapsizedSunkAndThrownBodiesComeBackToTheirDraft) {
  HullCoefficients damped;
  damped.heaveDamping = damped.rollDamping = damped.pitchDamping = 0.5;
  for (const double z : {-5.0, 4.0, 0.0}) {
    Afloat body(box(), boxMass(), damped, free, WaveField({}), 0.01);
    body.mujoco->data->qpos[2] = z;
    body.mujoco->data->qpos[3] = std::cos(1.4);
    body.mujoco->data->qpos[4] = std::sin(1.4);
    double highest = z;
    while (body.time() < 40.0) {
      body.step();
      ASSERT_TRUE(std::isfinite(body.height()));
      highest = std::max(highest, body.height());
    }
    const HullLoads now = [&] {
      LoadScratch scratch;
      HullPose pose;
      pose.position = {0.0, 0.0, body.height()};
      const mjtNum* q = body.mujoco->data->qpos + 3;
      pose.worldFromBody = {q[0], q[1], q[2], q[3]};
      return loads(*body.hull, pose, body.water, 0.0, scratch);
    }();
    EXPECT_NEAR(now.submergedVolume, length * beam * draft, 1e-3 * length * beam * draft) << z;
  }
}

}  // namespace
}  // namespace seaway::bridge::test
