#pragma once

#include <filesystem>
#include <string>

#include "surface/hull/triangle_mesh.h"

namespace seaway {

/// What a mesh file does not say of itself.
struct HullFileSettings {
  double metresPerUnit = 1.0;  ///< > 0
  std::string forward = "+x";  ///< axis of the file that points to the bow: [+-][xyz]
  std::string up = "+z";       ///< axis of the file that points up; not along `forward`
};

/// Reads STL, OBJ, glTF or GLB (whatever Assimp knows by the file's ending) into the body frame:
/// x forward, y to port, z up, m; all of a file's parts together, polygons in triangles. Vertices
/// within 1e-6 of the longest side become one. Throws InputError for a file that cannot be read,
/// holds no triangle or a coordinate that is not finite, and for settings out of range.
TriangleMesh readHullFile(const std::filesystem::path& file, const HullFileSettings& settings = {});

/// Throws InputError unless `file` ends in .stl, .obj or .glb.
void requireHullFormat(const std::filesystem::path& file);

/// What an STL (binary), OBJ or GLB file of a mesh holds, in metres and the body frame; the format
/// is that of the ending of `file`, which is not touched. Throws InputError for another ending.
std::string hullFileBytes(const std::filesystem::path& file, const TriangleMesh& mesh);

}  // namespace seaway
