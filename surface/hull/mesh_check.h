#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "surface/hull/triangle_mesh.h"

namespace seaway {

/// What is right and wrong with a mesh that is to float.
struct MeshReport {
  std::size_t triangles = 0, vertices = 0;
  std::size_t openEdges = 0;          ///< edges of one triangle only: a hole
  std::size_t crowdedEdges = 0;       ///< edges of more than two triangles
  std::size_t reversedEdges = 0;      ///< edges whose two triangles face opposite ways
  std::size_t zeroAreaTriangles = 0;  ///< area below 1e-12 of the longest edge's square
  std::size_t selfIntersections = 0;  ///< pairs of triangles that pass through one another
  std::size_t parts = 0;              ///< connected pieces
  bool facesOutward = true;           ///< its signed volume is positive
  bool finite = true;                 ///< every vertex is
  double millimetreLength = 0.0;      ///< longest side in m where it looks like mm; else 0

  /// Closed, and every two neighbours face the same way.
  bool watertight() const {
    return finite && triangles > 0 && openEdges + crowdedEdges + reversedEdges == 0;
  }
};

/// Longest side above which a mesh is taken for one in millimetres, m: no ship is longer.
inline constexpr double longestShip = 500.0;

/// Examines a mesh whose common vertices are shared (see welded). Self-intersections are searched
/// for among triangles without a common vertex, exactly but for rounding; lying on one another in
/// one plane is not counted. Some 2 ms for 1000 triangles of a hull, O(n√n).
MeshReport checkMesh(const TriangleMesh& mesh);

/// Faults that forbid buoyancy, one sentence each; empty where there are none.
std::vector<std::string> faultsOf(const MeshReport& report);
/// What should be looked at but can be lived with, one sentence each.
std::vector<std::string> warningsOf(const MeshReport& report);

}  // namespace seaway
