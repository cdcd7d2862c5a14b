#include "surface/hull/mesh_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <numeric>

namespace seaway {
namespace {

using Triangle = TriangleMesh::Triangle;

/// How often an edge is walked from its lower to its higher vertex, and back.
struct EdgeUse {
  int forth = 0, back = 0;
};

void countEdges(const TriangleMesh& mesh, MeshReport& report) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, EdgeUse> edges;
  for (const Triangle& t : mesh.triangles) {
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t from = t[i], to = t[(i + 1) % 3];
      EdgeUse& use = edges[std::minmax(from, to)];
      ++(from < to ? use.forth : use.back);
    }
  }
  for (const auto& [ends, use] : edges) {
    const int all = use.forth + use.back;
    if (all == 1) ++report.openEdges;
    if (all > 2) ++report.crowdedEdges;
    if (all == 2 && use.forth != 1) ++report.reversedEdges;
  }
}

std::size_t countParts(const TriangleMesh& mesh) {
  std::vector<std::uint32_t> parent(mesh.vertices.size());
  std::iota(parent.begin(), parent.end(), 0u);
  const auto root = [&](std::uint32_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  for (const Triangle& t : mesh.triangles) {
    parent[root(t.x)] = root(t.y);
    parent[root(t.y)] = root(t.z);
  }
  std::vector<std::uint32_t> roots;
  for (const Triangle& t : mesh.triangles) roots.push_back(root(t.x));
  std::sort(roots.begin(), roots.end());
  return static_cast<std::size_t>(std::unique(roots.begin(), roots.end()) - roots.begin());
}

struct Face {
  std::array<glm::dvec3, 3> corner;
  glm::dvec3 lower, upper;
  Triangle index;
};

/// Whether the line from p to q passes through the inside of a face (Möller & Trumbore 1997).
bool crosses(const glm::dvec3& p, const glm::dvec3& q, const Face& face) {
  const glm::dvec3 along = q - p;
  const glm::dvec3 e = face.corner[1] - face.corner[0], f = face.corner[2] - face.corner[0];
  const glm::dvec3 normal = glm::cross(along, f);
  const double determinant = glm::dot(e, normal);
  const double size = glm::length(e) * glm::length(f) * glm::length(along);
  if (std::abs(determinant) <= 1e-12 * size) return false;
  const glm::dvec3 arm = p - face.corner[0], turned = glm::cross(arm, e);
  const double u = glm::dot(arm, normal) / determinant;
  const double v = glm::dot(along, turned) / determinant;
  const double s = glm::dot(f, turned) / determinant;
  constexpr double inside = 1e-9;  // touching is not passing through
  return u > inside && v > inside && u + v < 1.0 - inside && s > inside && s < 1.0 - inside;
}

bool shareVertex(const Triangle& a, const Triangle& b) {
  for (int i = 0; i < 3; ++i) {
    if (a[i] == b.x || a[i] == b.y || a[i] == b.z) return true;
  }
  return false;
}

bool intersect(const Face& a, const Face& b) {
  if (glm::any(glm::lessThan(a.upper, b.lower)) || glm::any(glm::lessThan(b.upper, a.lower)) ||
      shareVertex(a.index, b.index)) {
    return false;
  }
  for (int i = 0; i < 3; ++i) {
    const int next = (i + 1) % 3;
    if (crosses(a.corner[i], a.corner[next], b) || crosses(b.corner[i], b.corner[next], a)) {
      return true;
    }
  }
  return false;
}

/// Sweeps along the longest axis.
std::size_t countIntersections(const TriangleMesh& mesh) {
  std::vector<Face> faces;
  for (const Triangle& t : mesh.triangles) {
    Face face{{mesh.vertices[t.x], mesh.vertices[t.y], mesh.vertices[t.z]}, {}, {}, t};
    face.lower = glm::min(glm::min(face.corner[0], face.corner[1]), face.corner[2]);
    face.upper = glm::max(glm::max(face.corner[0], face.corner[1]), face.corner[2]);
    faces.push_back(face);
  }
  const glm::dvec3 size = boundsOf(mesh).size();
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  std::sort(faces.begin(), faces.end(),
            [axis](const Face& a, const Face& b) { return a.lower[axis] < b.lower[axis]; });
  std::size_t count = 0;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    for (std::size_t j = i + 1; j < faces.size(); ++j) {
      if (faces[j].lower[axis] > faces[i].upper[axis]) break;
      if (intersect(faces[i], faces[j])) ++count;
    }
  }
  return count;
}

std::string counted(std::size_t count, const char* one, const char* many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

}  // namespace

MeshReport checkMesh(const TriangleMesh& mesh) {
  MeshReport report;
  report.triangles = mesh.triangles.size();
  report.vertices = mesh.vertices.size();
  for (const glm::dvec3& v : mesh.vertices) report.finite &= std::isfinite(v.x + v.y + v.z);
  if (!report.finite) return report;
  const glm::dvec3 size = boundsOf(mesh).size();
  const double longest = std::max({size.x, size.y, size.z});
  if (longest > longestShip) report.millimetreLength = longest;
  for (const Triangle& t : mesh.triangles) {
    double edge = 0.0;
    for (int i = 0; i < 3; ++i) {
      edge = std::max(edge, glm::distance(mesh.vertices[t[i]], mesh.vertices[t[(i + 1) % 3]]));
    }
    if (glm::length(areaVector(mesh, t)) <= 1e-12 * edge * edge) ++report.zeroAreaTriangles;
  }
  countEdges(mesh, report);
  report.parts = countParts(mesh);
  report.selfIntersections = countIntersections(mesh);
  report.facesOutward = massProperties(mesh).volume > 0.0;
  return report;
}

std::vector<std::string> faultsOf(const MeshReport& report) {
  std::vector<std::string> faults;
  if (!report.finite) faults.push_back("has vertices that are not finite");
  if (report.triangles == 0) faults.push_back("has no triangles");
  if (report.openEdges > 0) {
    faults.push_back("has a hole: " + counted(report.openEdges, "edge belongs", "edges belong") +
                     " to one triangle only");
  }
  if (report.crowdedEdges > 0) {
    faults.push_back(counted(report.crowdedEdges, "edge belongs", "edges belong") +
                     " to more than two triangles");
  }
  if (report.reversedEdges > 0) {
    faults.push_back(counted(report.reversedEdges, "edge lies", "edges lie") +
                     " between triangles that face opposite ways");
  }
  return faults;
}

std::vector<std::string> warningsOf(const MeshReport& report) {
  std::vector<std::string> warnings;
  if (report.watertight() && !report.facesOutward) {
    warnings.push_back("faces inwards; its triangles are turned round");
  }
  if (report.zeroAreaTriangles > 0) {
    warnings.push_back(
        counted(report.zeroAreaTriangles, "triangle has no area", "triangles have no area"));
  }
  if (report.selfIntersections > 0) {
    warnings.push_back(
        counted(report.selfIntersections, "pair of triangles passes", "pairs of triangles pass") +
        " through each other: volumes there count twice");
  }
  if (report.millimetreLength > 0.0) {
    char text[96];
    std::snprintf(text, sizeof text, "is %.6g m long: is its unit the millimetre?",
                  report.millimetreLength);
    warnings.emplace_back(text);
  }
  return warnings;
}

}  // namespace seaway
