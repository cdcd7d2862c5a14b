#pragma once

#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace seaway {

/// Triangles that share vertices, m; counter-clockwise seen from outside.
struct TriangleMesh {
  using Triangle = glm::vec<3, std::uint32_t>;
  std::vector<glm::dvec3> vertices;
  std::vector<Triangle> triangles;
};

/// Corners of the smallest box about a mesh, m; both 0 for a mesh without vertices.
struct MeshBounds {
  glm::dvec3 lower{0.0}, upper{0.0};
  glm::dvec3 size() const { return upper - lower; }
  glm::dvec3 middle() const { return 0.5 * (lower + upper); }
};
MeshBounds boundsOf(const TriangleMesh& mesh);

/// Half the cross product of two edges: area times outward normal, m².
glm::dvec3 areaVector(const TriangleMesh& mesh, const TriangleMesh::Triangle& triangle);

/// What the space inside a closed mesh weighs at a density of 1 (exact for the polyhedron, by the
/// divergence theorem).
struct MassProperties {
  double volume = 0.0;       ///< m³, negative where the triangles face inwards
  double area = 0.0;         ///< of the surface, m²
  glm::dvec3 centroid{0.0};  ///< m
  glm::dmat3 inertia{0.0};   ///< about the centroid, m⁵
};
MassProperties massProperties(const TriangleMesh& mesh);

/// The mesh with vertices no farther apart than `distance` m made one, and with triangles that
/// have thereby lost a corner left out.
TriangleMesh welded(const TriangleMesh& mesh, double distance);

/// The mesh with all triangles facing the other way.
TriangleMesh turnedInsideOut(const TriangleMesh& mesh);

/// The mesh moved by `offset` m.
TriangleMesh moved(const TriangleMesh& mesh, const glm::dvec3& offset);

}  // namespace seaway
