#include "surface/hull/triangle_mesh.h"

#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <unordered_map>

namespace seaway {
namespace {

using Cell = glm::vec<3, std::int64_t>;

struct CellHash {
  std::size_t operator()(const Cell& cell) const {
    const auto mixed = static_cast<std::uint64_t>(cell.x) * 0x9E3779B97F4A7C15u ^
                       static_cast<std::uint64_t>(cell.y) * 0xC2B2AE3D27D4EB4Fu ^
                       static_cast<std::uint64_t>(cell.z) * 0x165667B19E3779F9u;
    return static_cast<std::size_t>(mixed ^ (mixed >> 29));
  }
};

/// Finds a point seen before within a distance of a new one, by a grid of cells of that size.
class NearPoints {
 public:
  explicit NearPoints(double distance) : distance_(distance) {}

  /// Its index in `points`, to which it is added where none is near.
  std::uint32_t indexOf(const glm::dvec3& point, std::vector<glm::dvec3>& points) {
    const Cell home(glm::floor(point / distance_));
    for (std::int64_t i = 0; i < 27; ++i) {
      const Cell cell = home + Cell(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
      const auto [first, last] = cells_.equal_range(cell);
      for (auto found = first; found != last; ++found) {
        if (glm::distance(points[found->second], point) <= distance_) return found->second;
      }
    }
    const auto index = static_cast<std::uint32_t>(points.size());
    cells_.emplace(home, index);
    points.push_back(point);
    return index;
  }

 private:
  double distance_;
  std::unordered_multimap<Cell, std::uint32_t, CellHash> cells_;
};

}  // namespace

MeshBounds boundsOf(const TriangleMesh& mesh) {
  if (mesh.vertices.empty()) return {};
  MeshBounds bounds{mesh.vertices.front(), mesh.vertices.front()};
  for (const glm::dvec3& vertex : mesh.vertices) {
    bounds.lower = glm::min(bounds.lower, vertex);
    bounds.upper = glm::max(bounds.upper, vertex);
  }
  return bounds;
}

glm::dvec3 areaVector(const TriangleMesh& mesh, const TriangleMesh::Triangle& triangle) {
  const glm::dvec3& a = mesh.vertices[triangle.x];
  return 0.5 * glm::cross(mesh.vertices[triangle.y] - a, mesh.vertices[triangle.z] - a);
}

// Tetrahedra from the middle of the box to each triangle: ∫ r rᵀ dV of one with corners 0, a, b, c
// is det/120 (s sᵀ + a aᵀ + b bᵀ + c cᵀ), s = a + b + c.
MassProperties massProperties(const TriangleMesh& mesh) {
  const glm::dvec3 middle = boundsOf(mesh).middle();
  MassProperties result;
  glm::dvec3 first(0.0);
  glm::dmat3 second(0.0);
  for (const auto& triangle : mesh.triangles) {
    const glm::dvec3 a = mesh.vertices[triangle.x] - middle;
    const glm::dvec3 b = mesh.vertices[triangle.y] - middle;
    const glm::dvec3 c = mesh.vertices[triangle.z] - middle;
    const glm::dvec3 s = a + b + c;
    const double determinant = glm::dot(a, glm::cross(b, c));
    result.area += 0.5 * glm::length(glm::cross(b - a, c - a));
    result.volume += determinant / 6.0;
    first += determinant / 24.0 * s;
    second += determinant / 120.0 *
              (glm::outerProduct(s, s) + glm::outerProduct(a, a) + glm::outerProduct(b, b) +
               glm::outerProduct(c, c));
  }
  if (result.volume == 0.0) return result;
  const glm::dvec3 arm = first / result.volume;
  result.centroid = middle + arm;
  second -= result.volume * glm::outerProduct(arm, arm);
  result.inertia = glm::dmat3(second[0][0] + second[1][1] + second[2][2]) - second;
  return result;
}

TriangleMesh welded(const TriangleMesh& mesh, double distance) {
  TriangleMesh result;
  NearPoints near(distance);
  std::vector<std::uint32_t> index;
  for (const glm::dvec3& vertex : mesh.vertices) {
    index.push_back(near.indexOf(vertex, result.vertices));
  }
  for (const auto& triangle : mesh.triangles) {
    const TriangleMesh::Triangle t(index[triangle.x], index[triangle.y], index[triangle.z]);
    if (t.x != t.y && t.y != t.z && t.z != t.x) result.triangles.push_back(t);
  }
  return result;
}

TriangleMesh turnedInsideOut(const TriangleMesh& mesh) {
  TriangleMesh result = mesh;
  for (auto& triangle : result.triangles) std::swap(triangle.y, triangle.z);
  return result;
}

TriangleMesh moved(const TriangleMesh& mesh, const glm::dvec3& offset) {
  TriangleMesh result = mesh;
  for (glm::dvec3& vertex : result.vertices) vertex += offset;
  return result;
}

}  // namespace seaway
