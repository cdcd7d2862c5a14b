#include "surface/hull/hull_repair.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "surface/constants.h"
#include "surface/hull/analytic_hulls.h"
#include "surface/hull/mesh_check.h"
#include "surface/input_error.h"

namespace seaway {
namespace {

TEST(HullRepair, SphereWithAHoleAndFlippedTrianglesBecomesWatertight) {
  TriangleMesh mesh = sphereMesh(1.0);
  mesh.triangles.erase(mesh.triangles.begin() + 300);
  std::swap(mesh.triangles[20].x, mesh.triangles[20].y);
  ASSERT_FALSE(checkMesh(mesh).watertight());
  // The hole is a triangle with sides of 0.22.
  const TriangleMesh whole = repaired(mesh, {.voxelSize = 0.05, .widestHole = 0.2});
  const MeshReport report = checkMesh(whole);
  EXPECT_TRUE(report.watertight());
  EXPECT_TRUE(report.facesOutward);
  EXPECT_EQ(report.parts, 1u);
  // Half a voxel of radius is 7.5 % of the volume.
  EXPECT_NEAR(massProperties(whole).volume, 4.0 / 3.0 * pi, 0.075 * 4.0 / 3.0 * pi);
  EXPECT_NEAR(glm::length(massProperties(whole).centroid), 0.0, 0.02);
}

TEST(HullRepair, OverlappingBoxesBecomeOneSurface) {
  TriangleMesh mesh = boxMesh(2.0, 2.0, 2.0, 1.0, 12);
  const TriangleMesh other = moved(mesh, {1.0, 0.0, 0.0});
  for (const auto& t : other.triangles) {
    mesh.triangles.push_back(t + static_cast<std::uint32_t>(mesh.vertices.size()));
  }
  mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
  const TriangleMesh one = repaired(mesh, {.voxelSize = 0.1});
  EXPECT_TRUE(checkMesh(one).watertight());
  EXPECT_EQ(checkMesh(one).parts, 1u);
  EXPECT_EQ(checkMesh(one).selfIntersections, 0u);
  // Half a voxel of 32 m² of surface.
  EXPECT_NEAR(massProperties(one).volume, 12.0, 0.5 * 0.1 * 32.0);
}

TEST(HullRepair, PlatesEncloseNothing) {
  TriangleMesh plate;
  plate.vertices = {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {1.0, 1.0, 0.0}};
  plate.triangles = {{0u, 1u, 2u}};
  EXPECT_THROW(repaired(plate), InputError);
  EXPECT_THROW(repaired(plate, {.voxelSize = 1e-9}), InputError);
}

TEST(HullDistance, IsTheDistanceToASphere) {
  const HullDistance distance(sphereMesh(1.0, 13000), 0.05, 0.5);
  for (const double r : {0.6, 0.8, 1.0, 1.2, 1.4}) {
    const glm::dvec3 along = glm::normalize(glm::dvec3(0.3, -0.5, 0.8));
    EXPECT_NEAR(distance.at(r * along), r - 1.0, 0.5 * 0.05) << r;
  }
  EXPECT_LT(distance.at(glm::dvec3(0.0)), -0.4);
  EXPECT_GT(distance.at({5.0, 0.0, 0.0}), 0.4);
  EXPECT_GT(distance.memoryBytes(), 0u);
}

}  // namespace
}  // namespace seaway
