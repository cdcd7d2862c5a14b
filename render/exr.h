#pragma once

#include <filesystem>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace seaway::render {

/// Writes 32-bit float images, row by row from the top left, as OpenEXR files. Throws
/// std::runtime_error where that fails; what was written by then stays.

/// One channel, Z: metres, +inf where there is nothing.
void writeDepthExr(const std::filesystem::path& path, glm::ivec2 size,
                   const std::vector<float>& metres);

/// Three channels, N.X, N.Y, N.Z.
void writeNormalsExr(const std::filesystem::path& path, glm::ivec2 size,
                     const std::vector<glm::vec3>& normals);

/// Reads channel Z of a file. Throws std::runtime_error where there is none.
std::vector<float> readDepthExr(const std::filesystem::path& path, glm::ivec2& size);

}  // namespace seaway::render
