#include "surface/hull/mesh_calibration.h"

#include <gtest/gtest.h>

#include <cmath>

#include "surface/hull/analytic_hulls.h"
#include "surface/hull/hydrostatics.h"
#include "surface/hull/mesh_check.h"
#include "surface/input_error.h"

namespace seaway {
namespace {

/// Closed forms of Wigley's hull at its design draft.
struct Wigley {
  double length = 10.0, beam = 1.0, draft = 0.625;
  double volume() const { return 4.0 / 9.0 * length * beam * draft; }
  double area() const { return 2.0 / 3.0 * length * beam; }
  double keelToBuoyancy() const { return 5.0 / 8.0 * draft; }
  double transverse() const {  // ∫ (2/3) y³ dx
    return 2.0 / 3.0 * std::pow(0.5 * beam, 3) * length * 16.0 / 35.0;
  }
  double longitudinal() const { return beam * std::pow(length, 3) / 30.0; }
};

// Volume and waterplane are met to rounding; the rest follows to 0.05 %, as measured: KB −0.031 %,
// BM +0.023 and −0.030 %.
TEST(MeshCalibration, WigleyOf800TrianglesHasItsHydrostaticsWithinATwentiethOfAPercent) {
  const Wigley hull;
  const TriangleMesh mesh = calibrated(wigleyMesh(hull.length, hull.beam, hull.draft, 0.4, 800),
                                       hull.volume(), hull.area());
  ASSERT_LE(mesh.triangles.size(), 800u);
  EXPECT_TRUE(checkMesh(mesh).watertight());
  EXPECT_EQ(checkMesh(mesh).selfIntersections, 0u);
  const SubmergedPart part = submergedPart(mesh, WaterPlane::at(0.0));
  EXPECT_NEAR(part.volume, hull.volume(), 1e-9 * hull.volume());
  EXPECT_NEAR(part.waterplaneArea, hull.area(), 1e-9 * hull.area());
  EXPECT_NEAR(part.centre.z + hull.draft, hull.keelToBuoyancy(), 5e-4 * hull.keelToBuoyancy());
  const double transverse = hull.transverse() / hull.volume();
  const double longitudinal = hull.longitudinal() / hull.volume();
  EXPECT_NEAR(part.transverseRadius(), transverse, 5e-4 * transverse);
  EXPECT_NEAR(part.longitudinalRadius(), longitudinal, 5e-4 * longitudinal);
  EXPECT_NEAR(part.waterplaneCentre.x, 0.0, 1e-9);
}

TEST(MeshCalibration, AMeshThatIsRightIsLeftAlone) {
  const TriangleMesh mesh = boxMesh(4.0, 2.0, 1.0, 0.5, 300);
  const TriangleMesh same = calibrated(mesh, 4.0, 8.0);
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    EXPECT_NEAR(same.vertices[i].y, mesh.vertices[i].y, 1e-12);
  }
}

TEST(MeshCalibrationHard, FiguresOfAnotherHullAreRefused) {
  const TriangleMesh mesh = boxMesh(4.0, 2.0, 1.0, 0.5, 300);
  EXPECT_THROW(calibrated(mesh, 8.0, 8.0), InputError);
  EXPECT_THROW(calibrated(mesh, 4.0, 80.0), InputError);
  EXPECT_THROW(calibrated(mesh, NAN, 8.0), InputError);
  EXPECT_THROW(calibrated(moved(mesh, {0.0, 0.0, 3.0}), 4.0, 8.0), InputError);
}

}  // namespace
}  // namespace seaway
