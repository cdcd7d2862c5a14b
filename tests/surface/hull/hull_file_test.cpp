#include "surface/hull/hull_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <glm/geometric.hpp>

#include "surface/hull/analytic_hulls.h"
#include "surface/hull/hydrostatics.h"
#include "surface/hull/mesh_check.h"
#include "surface/input_error.h"

namespace seaway {
namespace {

namespace fs = std::filesystem;

class HullFile : public testing::Test {
 protected:
  HullFile()
      : folder_(fs::temp_directory_path() /
                (std::string("seaway_hull_") +
                 testing::UnitTest::GetInstance()->current_test_info()->name())) {
    fs::create_directories(folder_);
  }
  ~HullFile() override { fs::remove_all(folder_); }

  fs::path write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return folder_ / name;
  }

  fs::path folder_;
};
using HullFileHard = HullFile;

TEST_F(HullFile, MeshesComeBackFromEveryFormat) {
  const TriangleMesh mesh = wigleyMesh(10.0, 1.0, 0.6, 0.4);
  const MassProperties wanted = massProperties(mesh);
  for (const char* name : {"hull.stl", "hull.obj", "hull.glb"}) {
    write(name, hullFileBytes(name, mesh));
    const TriangleMesh read = readHullFile(folder_ / name);
    EXPECT_EQ(read.triangles.size(), mesh.triangles.size()) << name;
    EXPECT_EQ(read.vertices.size(), mesh.vertices.size()) << name;
    EXPECT_TRUE(checkMesh(read).watertight()) << name;
    // Files hold floats.
    EXPECT_NEAR(massProperties(read).volume, wanted.volume, 1e-6 * wanted.volume) << name;
    EXPECT_NEAR(glm::distance(massProperties(read).centroid, wanted.centroid), 0.0, 1e-6) << name;
  }
}

TEST_F(HullFile, UnitsAndAxesAreThoseStated) {
  const fs::path file = write("one.obj",
                              "v 0 0 0\nv 2000 0 0\nv 0 1000 0\nv 0 0 -500\n"
                              "f 1 2 3\nf 1 4 2\nf 2 4 3\nf 1 3 4\n");
  // glTF's habit: y up, z towards the viewer; the bow along −z here.
  const TriangleMesh mesh =
      readHullFile(file, {.metresPerUnit = 1e-3, .forward = "-z", .up = "+y"});
  const MeshBounds bounds = boundsOf(mesh);
  EXPECT_NEAR(bounds.upper.x, 0.5, 1e-6);
  EXPECT_NEAR(bounds.upper.z, 1.0, 1e-6);
  EXPECT_NEAR(bounds.lower.y, -2.0, 1e-6);  // the file's x is starboard
  EXPECT_NEAR(massProperties(mesh).volume, 2.0 * 1.0 * 0.5 / 6.0, 1e-6);
}

TEST_F(HullFile, BadSettingsAndFilesAreRefusedWithTheirReason) {
  const fs::path file = write("one.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_THROW(readHullFile(file, {.forward = "x"}), InputError);
  EXPECT_THROW(readHullFile(file, {.forward = "+x", .up = "-x"}), InputError);
  EXPECT_THROW(readHullFile(file, {.metresPerUnit = 0.0}), InputError);
  EXPECT_THROW(readHullFile(folder_ / "missing.stl"), InputError);
  EXPECT_THROW(readHullFile(folder_), InputError);
  EXPECT_THROW(readHullFile(write("text.stl", "no mesh")), InputError);
  EXPECT_THROW(readHullFile(write("points.obj", "v 0 0 0\nv 1 0 0\n")), InputError);
  EXPECT_THROW(hullFileBytes("hull.xyz", boxMesh(1, 1, 1, 0)), InputError);
}

TEST(MeshCheck, HolesFlippedTrianglesAndMillimetresAreFound) {
  TriangleMesh mesh = boxMesh(10.0, 3.0, 2.0, 1.0);
  EXPECT_TRUE(faultsOf(checkMesh(mesh)).empty());
  EXPECT_TRUE(warningsOf(checkMesh(mesh)).empty());

  TriangleMesh holed = mesh;
  holed.triangles.pop_back();
  EXPECT_EQ(checkMesh(holed).openEdges, 3u);
  EXPECT_FALSE(faultsOf(checkMesh(holed)).empty());

  TriangleMesh flipped = mesh;
  std::swap(flipped.triangles[7].x, flipped.triangles[7].y);
  EXPECT_EQ(checkMesh(flipped).reversedEdges, 3u);

  EXPECT_FALSE(checkMesh(turnedInsideOut(mesh)).facesOutward);
  EXPECT_TRUE(faultsOf(checkMesh(turnedInsideOut(mesh))).empty());
  EXPECT_EQ(warningsOf(checkMesh(turnedInsideOut(mesh))).size(), 1u);

  for (glm::dvec3& vertex : mesh.vertices) vertex *= 1000.0;
  ASSERT_EQ(warningsOf(checkMesh(mesh)).size(), 1u);
  EXPECT_NE(warningsOf(checkMesh(mesh)).front().find("millimetre"), std::string::npos);
}

TEST(MeshCheck, BoxesThatPassThroughEachOtherAreReported) {
  TriangleMesh mesh = boxMesh(2.0, 2.0, 2.0, 1.0, 12);
  const TriangleMesh other = moved(boxMesh(2.0, 2.0, 2.0, 1.0, 12), {1.1, 0.3, 0.2});
  for (const auto& t : other.triangles) {
    mesh.triangles.push_back(t + static_cast<std::uint32_t>(mesh.vertices.size()));
  }
  mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
  const MeshReport report = checkMesh(mesh);
  EXPECT_GT(report.selfIntersections, 0u);
  EXPECT_EQ(report.parts, 2u);
  EXPECT_TRUE(report.watertight());
}

TEST_F(HullFileHard, TrianglesWithoutAreaAreDroppedOrReported) {
  // The corner between 2 and 3 is doubled, and a sliver lies along an edge.
  const fs::path file = write("sliver.obj",
                              "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 1 0 0\nv 0.5 0 0\n"
                              "f 1 3 2\nf 1 5 4\nf 2 3 4\nf 1 4 3\nf 2 5 3\n");
  const TriangleMesh mesh = readHullFile(file);
  EXPECT_EQ(mesh.triangles.size(), 4u);
  EXPECT_TRUE(checkMesh(mesh).watertight());
  TriangleMesh sliver = mesh;
  const TriangleMesh::Triangle t = mesh.triangles[0];
  sliver.vertices.push_back(0.5 * (mesh.vertices[t.x] + mesh.vertices[t.y]));
  sliver.triangles.emplace_back(t.x, t.y, static_cast<std::uint32_t>(mesh.vertices.size()));
  EXPECT_EQ(checkMesh(sliver).zeroAreaTriangles, 1u);
}

}  // namespace
}  // namespace seaway
