#pragma once

#include <cstddef>
#include <string>

#include "surface/hull/hull_file.h"
#include "surface/hull/triangle_mesh.h"

namespace seaway::bridge {

/// A hull's mesh by its name: a file (STL, OBJ, glTF), or a shape with its dimensions in m:
/// `box:LENGTH,BEAM,DEPTH`, `wigley:LENGTH,BEAM,DRAFT,FREEBOARD`,
/// `open_wigley:LENGTH,BEAM,DRAFT,FREEBOARD,WALL`, `sphere:RADIUS`,
/// `spar:DIAMETER,DRAFT,FREEBOARD`, of about `triangles` triangles. Shapes have z = 0 at their
/// design waterline; a box floats half deep. Not checked. Throws InputError for what is neither.
TriangleMesh hullByName(const std::string& name, const HullFileSettings& settings = {},
                        std::size_t triangles = 800);

}  // namespace seaway::bridge
