#include "surface/hull/hydrostatics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "surface/angles.h"
#include "surface/hull/analytic_hulls.h"
#include "surface/hull/mesh_check.h"
#include "surface/input_error.h"

namespace seaway {
namespace {

void expectNear(double value, double theory, double relative, const char* what) {
  EXPECT_NEAR(value, theory, relative * std::abs(theory))
      << what << ": off by " << 100.0 * (value / theory - 1.0) << " %";
}

/// Largest errors that a mesh of so many triangles may have. Flat triangles cut off the square of
/// their edges from a curve: 16 times as many, a 16th of the error.
struct Resolution {
  std::size_t triangles;
  double error;
};
class ClosedForms : public testing::TestWithParam<Resolution> {};
INSTANTIATE_TEST_SUITE_P(Hydrostatics, ClosedForms,
                         testing::Values(Resolution{800, 5e-3}, Resolution{13000, 3e-4}));

TEST_P(ClosedForms, BoxIsExactAtAnyResolution) {
  const double l = 10.0, b = 3.0, t = 0.8;
  const TriangleMesh mesh = boxMesh(l, b, 2.0, t, GetParam().triangles);
  EXPECT_LE(mesh.triangles.size(), GetParam().triangles);
  const SubmergedPart part = submergedPart(mesh, WaterPlane::at(0.0));
  expectNear(part.volume, l * b * t, 1e-12, "V");
  EXPECT_NEAR(part.centre.z, -t / 2.0, 1e-12);
  EXPECT_NEAR(part.centre.x, 0.0, 1e-12);
  expectNear(part.waterplaneArea, l * b, 1e-12, "A");
  expectNear(part.transverseMoment, l * b * b * b / 12.0, 1e-12, "I_T");
  expectNear(part.longitudinalMoment, b * l * l * l / 12.0, 1e-12, "I_L");
  expectNear(part.transverseRadius(), b * b / (12.0 * t), 1e-12, "BM");
  expectNear(part.wettedArea, l * b + 2.0 * t * (l + b), 1e-12, "S");
}

TEST_P(ClosedForms, WigleyIsRightToItsMeshsBias) {
  const double l = 10.0, b = 1.0, t = 0.625;
  const TriangleMesh mesh = wigleyMesh(l, b, t, 0.4, GetParam().triangles);
  EXPECT_LE(mesh.triangles.size(), GetParam().triangles);
  EXPECT_GE(mesh.triangles.size(), GetParam().triangles * 9 / 10);
  const SubmergedPart part = submergedPart(mesh, WaterPlane::at(0.0));
  const double error = GetParam().error;
  expectNear(part.volume, 4.0 / 9.0 * l * b * t, error, "V");
  expectNear(part.waterplaneArea, 2.0 / 3.0 * l * b, error, "A");
  expectNear(part.centre.z + t, 5.0 / 8.0 * t, error, "KB");
  expectNear(part.transverseMoment, 4.0 / 105.0 * l * b * b * b, error, "I_T");
  expectNear(part.transverseRadius(), 3.0 / 35.0 * b * b / t, error, "BM");
}

TEST_P(ClosedForms, SphereIsRightToItsMeshsBias) {
  const double r = 2.0;
  const TriangleMesh mesh = sphereMesh(r, GetParam().triangles);
  EXPECT_LE(mesh.triangles.size(), GetParam().triangles);
  const SubmergedPart part = submergedPart(mesh, WaterPlane::at(0.0));
  const double error = GetParam().error;
  expectNear(part.volume, 2.0 / 3.0 * pi * r * r * r, error, "V");
  expectNear(part.centre.z, -3.0 / 8.0 * r, error, "KB");
  expectNear(part.waterplaneArea, pi * r * r, error, "A");
  expectNear(part.transverseMoment, pi * r * r * r * r / 4.0, error, "I");
  // BM of a ball is the height of its centre above B.
  expectNear(part.transverseRadius(), 3.0 / 8.0 * r, error, "BM");
}

TEST_P(ClosedForms, SparIsRightToItsMeshsBias) {
  const double d = 1.0, t = 6.0;
  const TriangleMesh mesh = sparMesh(d, t, 2.0, GetParam().triangles);
  const SubmergedPart part = submergedPart(mesh, WaterPlane::at(0.0));
  expectNear(part.volume, pi / 4.0 * d * d * t, 1e-12, "V");
  expectNear(part.waterplaneArea, pi / 4.0 * d * d, 1e-12, "A");
  expectNear(part.transverseMoment, pi / 64.0 * d * d * d * d, GetParam().error, "I");
}

TEST(Hydrostatics, AnalyticHullsAreWatertightAndFaceOutwards) {
  for (const std::size_t triangles : {100, 800, 13000}) {
    for (const TriangleMesh& mesh :
         {boxMesh(10.0, 3.0, 2.0, 0.8, triangles), wigleyMesh(10.0, 1.0, 0.6, 0.4, triangles),
          sphereMesh(1.0, triangles), sparMesh(1.0, 6.0, 2.0, triangles)}) {
      const MeshReport report = checkMesh(mesh);
      EXPECT_TRUE(report.watertight()) << triangles;
      EXPECT_TRUE(report.facesOutward);
      EXPECT_EQ(report.parts, 1u);
      EXPECT_EQ(report.selfIntersections, 0u);
      EXPECT_EQ(report.zeroAreaTriangles, 0u);
    }
  }
}

TEST(Hydrostatics, MassPropertiesOfABoxAreItsClosedForms) {
  const MassProperties mass = massProperties(moved(boxMesh(4.0, 3.0, 2.0, 0.0), {5.0, -6.0, 7.0}));
  EXPECT_NEAR(mass.volume, 24.0, 1e-11);
  EXPECT_NEAR(glm::distance(mass.centroid, {5.0, -6.0, 8.0}), 0.0, 1e-12);
  EXPECT_NEAR(mass.inertia[0][0], 24.0 * (9.0 + 4.0) / 12.0, 1e-10);
  EXPECT_NEAR(mass.inertia[1][1], 24.0 * (16.0 + 4.0) / 12.0, 1e-10);
  EXPECT_NEAR(mass.inertia[2][2], 24.0 * (16.0 + 9.0) / 12.0, 1e-10);
  EXPECT_NEAR(mass.inertia[0][1], 0.0, 1e-10);
  EXPECT_NEAR(mass.area, 2.0 * (12.0 + 8.0 + 6.0), 1e-11);
}

TEST(Hydrostatics, WhatIsUnderAndWhatIsOverThePlaneMakeTheWholeMesh) {
  const TriangleMesh mesh = wigleyMesh(10.0, 1.0, 0.6, 0.4);
  const MassProperties whole = massProperties(mesh);
  for (const double heel : {0.0, 0.7, 2.0, -3.0}) {
    const WaterPlane below = WaterPlane::at(0.05, heel, 0.1);
    const SubmergedPart under = submergedPart(mesh, below);
    const SubmergedPart over = submergedPart(mesh, {-below.up, -below.height});
    EXPECT_NEAR(under.volume + over.volume, whole.volume, 1e-12 * whole.volume);
    EXPECT_NEAR(under.wettedArea + over.wettedArea, whole.area, 1e-12 * whole.area);
    const glm::dvec3 centre =
        (under.volume * under.centre + over.volume * over.centre) / whole.volume;
    EXPECT_NEAR(glm::distance(centre, whole.centroid), 0.0, 1e-12);
  }
}

FloatingBody homogeneous(const TriangleMesh& mesh, double part) {
  const MassProperties mass = massProperties(mesh);
  return {&mesh, part * seaWaterDensity * mass.volume, mass.centroid};
}

TEST(Hydrostatics, BoxesComeToRestAtArchimedesDraftFromAnyNearAttitude) {
  const TriangleMesh mesh = boxMesh(10.0, 3.0, 2.0, 1.0);
  const FloatingBody body = homogeneous(mesh, 0.4);
  for (const double heel : {0.0, 0.3, -0.3}) {
    const Equilibrium rest = equilibrium(body, heel, 0.05);
    EXPECT_TRUE(rest.converged);
    EXPECT_NEAR(rest.heel, 0.0, 1e-9);
    EXPECT_NEAR(rest.trim, 0.0, 1e-9);
    EXPECT_NEAR(rest.plane.height, -1.0 + 0.8, 1e-9);
    EXPECT_NEAR(rest.transverseMetacentricHeight, 0.4 + 9.0 / 9.6 - 1.0, 1e-9);
    EXPECT_NEAR(rest.longitudinalMetacentricHeight, 0.4 + 100.0 / 9.6 - 1.0, 1e-8);
  }
}

// A weight that is off by y heels a wall-sided box until GM tan φ (1 + BM/(2 GM) tan² φ) = y.
TEST(Hydrostatics, WeightsToPortHeelToPort) {
  const TriangleMesh mesh = boxMesh(10.0, 3.0, 2.0, 1.0);
  FloatingBody body = homogeneous(mesh, 0.4);
  body.centreOfGravity.y = 0.03;
  const Equilibrium rest = equilibrium(body);
  ASSERT_TRUE(rest.converged);
  EXPECT_LT(rest.heel, 0.0);
  const double gm = 0.4 + 9.0 / 9.6 - 1.0, bm = 9.0 / 9.6, t = std::tan(-rest.heel);
  EXPECT_NEAR(t * (gm + 0.5 * bm * t * t), 0.03, 1e-9);
}

TEST(Hydrostatics, WeightsForwardTrimTheBowDown) {
  const TriangleMesh mesh = boxMesh(10.0, 3.0, 2.0, 1.0);
  FloatingBody body = homogeneous(mesh, 0.4);
  body.centreOfGravity.x = 0.1;
  const Equilibrium rest = equilibrium(body);
  ASSERT_TRUE(rest.converged);
  EXPECT_LT(rest.trim, 0.0);
}

// Scribanti's wall-sided formula GZ = sin φ (GM + BM/2 tan² φ), exact while neither deck nor bilge
// meets the water.
TEST(Hydrostatics, RightingLeversFollowTheWallSidedFormula) {
  const TriangleMesh mesh = boxMesh(10.0, 3.0, 2.0, 1.0);
  const FloatingBody body = homogeneous(mesh, 0.4);
  std::vector<double> heels;
  for (int degree = 0; degree <= 25; degree += 5) heels.push_back(radiansFromDegrees(degree));
  const double gm = 0.4 + 9.0 / 9.6 - 1.0, bm = 9.0 / 9.6;
  for (const RightingLever& lever : rightingLevers(body, heels)) {
    const double t = std::tan(lever.heel);
    EXPECT_NEAR(lever.lever, std::sin(lever.heel) * (gm + 0.5 * bm * t * t), 1e-9);
  }
}

TEST(Hydrostatics, RightingLeversOfASymmetricBodyVanishUprightAndUpsideDown) {
  const TriangleMesh mesh = wigleyMesh(10.0, 1.0, 0.6, 0.4);
  FloatingBody body = homogeneous(mesh, 0.5);
  body.centreOfGravity.z = -0.2;
  std::vector<double> heels;
  for (int degree = 0; degree <= 180; degree += 10) heels.push_back(radiansFromDegrees(degree));
  const auto levers = rightingLevers(body, heels);
  EXPECT_NEAR(levers.front().lever, 0.0, 1e-9);
  EXPECT_NEAR(levers.back().lever, 0.0, 1e-9);
  EXPECT_GT(levers[2].lever, 0.0);
  // Its slope at 0 is GM.
  const Equilibrium rest = equilibrium(body);
  const std::vector<double> small{1e-3};
  EXPECT_NEAR(rightingLevers(body, small).front().lever, 1e-3 * rest.transverseMetacentricHeight,
              1e-7);
}

TEST(HydrostaticsHard, BodiesThatSinkOrWeighNothingAreRefused) {
  const TriangleMesh mesh = boxMesh(1.0, 1.0, 1.0, 0.5);
  for (const double mass : {0.0, -1.0, 1026.0, 1e9, std::nan("")}) {
    EXPECT_THROW(equilibrium({&mesh, mass, glm::dvec3(0.0)}), InputError) << mass;
  }
  for (const double volume : {0.0, 1.0, 2.0, std::nan("")}) {
    EXPECT_THROW(planeOfVolume(mesh, volume), InputError) << volume;
  }
}

TEST(HydrostaticsHard, CubesOfAMillimetreAndTankersBalance) {
  for (const double scale : {1e-3, 400.0}) {
    const TriangleMesh mesh = boxMesh(scale, 0.15 * scale, 0.08 * scale, 0.04 * scale);
    for (const double part : {0.01, 0.5, 0.99}) {
      FloatingBody body = homogeneous(mesh, part);
      body.centreOfGravity.z = -0.039 * scale;
      const Equilibrium rest = equilibrium(body, 0.02, 0.001);
      EXPECT_TRUE(rest.converged) << scale << " " << part;
      EXPECT_NEAR(rest.plane.height, (0.08 * part - 0.04) * scale, 1e-9 * scale);
    }
  }
}

}  // namespace
}  // namespace seaway
