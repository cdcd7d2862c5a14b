#pragma once

#include <filesystem>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "surface/hull/hull_file.h"
#include "surface/hull/triangle_mesh.h"

namespace seaway {

/// A mesh to be looked at, by material.
struct ColouredMesh {
  struct Part {
    TriangleMesh mesh;
    /// Linear reflectance, each in [0, 1]; empty where the file gives none.
    std::optional<glm::vec3> colour;
  };
  std::vector<Part> parts;           ///< those without triangles are left out
  std::vector<std::string> remarks;  ///< what of the file is not taken over, a sentence each
};

/// Reads STL, OBJ, glTF or GLB (whatever Assimp knows by the file's ending) into a body frame as
/// readHullFile does, a part for each material with its base colour (glTF: `baseColorFactor`; OBJ:
/// `Kd`, taken as linear). Triangles without area are left out. Textures are not drawn; they must
/// be there. Throws InputError, naming the file, where it cannot be read, refers to a file that is
/// not there (which is named: a material library, a texture, a buffer), holds no triangle, holds
/// only triangles without area, or has a coordinate that is not finite; and for settings out of
/// range.
ColouredMesh readColouredMesh(const std::filesystem::path& file,
                              const HullFileSettings& settings = {});

}  // namespace seaway
