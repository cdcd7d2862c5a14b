#pragma once

#include <glm/vec4.hpp>
#include <vector>

#include "surface/hull/triangle_mesh.h"

namespace seaway {

/// A convex room inside an open hull, which the sea does not enter over its rim.
struct HullRoom {
  /// Outward unit normal in xyz, distance from the origin in w: inside, dot(n, p) < w for all.
  std::vector<glm::dvec4> planes;  ///< at most 12
};

/// The hollows of a closed mesh that are open above: what is enclosed at its own height by the
/// hull, up to the lowest point of its rim (a decked hull has none). Found on a lattice of 160
/// points along the longest side by the mesh's signed distance (HullDistance); walls thinner than
/// half a lattice step may leak. Each hollow is cut into pieces along x, convex by eight planes
/// about their sections that run straight between the ends: hollows that are convex seen from
/// inside are filled within a lattice step, and pass the outside of a wall of two steps by no more
/// where its section is round; others are overfilled.
std::vector<HullRoom> roomsOf(const TriangleMesh& mesh);

}  // namespace seaway
