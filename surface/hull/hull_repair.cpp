#include "surface/hull/hull_repair.h"

#include <openvdb/openvdb.h>
#include <openvdb/tools/Interpolation.h>
#include <openvdb/tools/MeshToVolume.h>
#include <openvdb/tools/VolumeToMesh.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numeric>

#include "surface/input_error.h"

namespace seaway {
namespace {

using openvdb::FloatGrid;
using openvdb::Vec3s;

void startOpenVdb() {
  static std::once_flag started;
  std::call_once(started, [] { openvdb::initialize(); });
}

struct Soup {
  std::vector<Vec3s> points;
  std::vector<openvdb::Vec3I> triangles;
};

Soup soupOf(const TriangleMesh& mesh) {
  Soup soup;
  for (const glm::dvec3& v : mesh.vertices) {
    soup.points.emplace_back(static_cast<float>(v.x), static_cast<float>(v.y),
                             static_cast<float>(v.z));
  }
  for (const auto& t : mesh.triangles) soup.triangles.emplace_back(t.x, t.y, t.z);
  return soup;
}

openvdb::math::Transform::Ptr voxels(double size) {
  return openvdb::math::Transform::createLinearTransform(size);
}

/// Where a grid has the value `level`, triangles facing rising values.
TriangleMesh surfaceAt(const FloatGrid& grid, double level) {
  std::vector<Vec3s> points;
  std::vector<openvdb::Vec3I> triangles;
  std::vector<openvdb::Vec4I> quads;
  openvdb::tools::volumeToMesh(grid, points, triangles, quads, level);
  TriangleMesh mesh;
  for (const Vec3s& p : points) mesh.vertices.emplace_back(p.x(), p.y(), p.z());
  const auto add = [&](openvdb::Index32 a, openvdb::Index32 b, openvdb::Index32 c) {
    mesh.triangles.emplace_back(a, c, b);  // OpenVDB's faces are clockwise from outside
  };
  for (const auto& t : triangles) add(t[0], t[1], t[2]);
  for (const auto& q : quads) {
    add(q[0], q[1], q[2]);
    add(q[0], q[2], q[3]);
  }
  return mesh;
}

/// Each connected part that encloses something, seen from outside. Walls of rooms within face the
/// other way and go.
TriangleMesh outermostParts(const TriangleMesh& mesh) {
  std::vector<std::uint32_t> parent(mesh.vertices.size());
  std::iota(parent.begin(), parent.end(), 0u);
  const auto root = [&](std::uint32_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  for (const auto& t : mesh.triangles) {
    parent[root(t.x)] = root(t.y);
    parent[root(t.y)] = root(t.z);
  }
  std::vector<double> volume(mesh.vertices.size(), 0.0);
  for (const auto& t : mesh.triangles) {
    const glm::dvec3 &a = mesh.vertices[t.x], &b = mesh.vertices[t.y], &c = mesh.vertices[t.z];
    volume[root(t.x)] += glm::dot(a, glm::cross(b, c)) / 6.0;
  }
  TriangleMesh kept{mesh.vertices, {}};
  for (const auto& t : mesh.triangles) {
    if (volume[root(t.x)] > 0.0) kept.triangles.push_back(t);
  }
  return kept;
}

double longestSide(const TriangleMesh& mesh) {
  const glm::dvec3 size = boundsOf(mesh).size();
  return std::max({size.x, size.y, size.z});
}

}  // namespace

TriangleMesh repaired(const TriangleMesh& mesh, const RepairSettings& settings) {
  const double longest = longestSide(mesh);
  const double voxel = settings.voxelSize > 0.0 ? settings.voxelSize : longest / 150.0;
  const double hole = settings.widestHole > 0.0 ? settings.widestHole : 4.0 * voxel;
  if (!(settings.voxelSize >= 0.0) || !(settings.widestHole >= 0.0) || !std::isfinite(hole)) {
    throw InputError("the voxel size and the widest hole must be >= 0 m");
  }
  if (!(longest / voxel <= 1000.0) || !(hole <= 0.5 * longest)) {
    throw InputError(
        "a voxel must be at least a thousandth of the hull's longest side, a hole at "
        "most half of it");
  }
  startOpenVdb();
  const Soup soup = soupOf(mesh);
  const double thickness = std::max(0.5 * hole, 1.5 * voxel);
  const auto reach = static_cast<float>(thickness / voxel + 3.0);
  const auto distance = openvdb::tools::meshToUnsignedDistanceField<FloatGrid>(
      *voxels(voxel), soup.points, soup.triangles, {}, reach);
  distance->setGridClass(openvdb::GRID_LEVEL_SET);  // decides which way surfaces face
  const TriangleMesh thick = outermostParts(surfaceAt(*distance, thickness));
  if (thick.triangles.empty()) throw InputError("nothing is left of the hull to repair");
  const Soup outer = soupOf(thick);
  const auto inside = openvdb::tools::meshToLevelSet<FloatGrid>(*voxels(voxel), outer.points,
                                                                outer.triangles, {}, reach);
  TriangleMesh thin = welded(outermostParts(surfaceAt(*inside, -thickness)), 1e-4 * voxel);
  // Thickened plates without an inside thin away to nothing.
  if (massProperties(thin).volume < 1e-3 * massProperties(thick).volume) {
    throw InputError("the hull encloses nothing: its holes are wider than " + std::to_string(hole) +
                     " m");
  }
  return thin;
}

struct HullDistance::Grid {
  FloatGrid::Ptr distance;
};

HullDistance::HullDistance(const TriangleMesh& mesh, double voxelSize, double band)
    : grid_(std::make_unique<Grid>()) {
  if (!(voxelSize > 0.0) || !(band > voxelSize) || !std::isfinite(band)) {
    throw InputError("a distance field needs 0 < voxel size < band");
  }
  startOpenVdb();
  const Soup soup = soupOf(mesh);
  grid_->distance = openvdb::tools::meshToLevelSet<FloatGrid>(
      *voxels(voxelSize), soup.points, soup.triangles, {}, static_cast<float>(band / voxelSize));
}

HullDistance::~HullDistance() = default;
HullDistance::HullDistance(HullDistance&&) noexcept = default;
HullDistance& HullDistance::operator=(HullDistance&&) noexcept = default;

double HullDistance::at(const glm::dvec3& point) const {
  const auto& grid = *grid_->distance;
  const auto index = grid.transform().worldToIndex(openvdb::Vec3d(point.x, point.y, point.z));
  return openvdb::tools::BoxSampler::sample(grid.tree(), index);
}

std::size_t HullDistance::memoryBytes() const { return grid_->distance->memUsage(); }

}  // namespace seaway
