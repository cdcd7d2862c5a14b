#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "surface/hull/triangle_mesh.h"

namespace seaway {

/// The convex outline of where the plane of a height z cuts a mesh, counter-clockwise seen from
/// above, m; empty where it does not. O(n log n).
std::vector<glm::dvec2> sectionOutline(const TriangleMesh& mesh, double z);

}  // namespace seaway
