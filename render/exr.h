#pragma once

#include <filesystem>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace seaway::render {

/// Writes images of floats, row by row from the top left, as OpenEXR files. Throws
/// std::runtime_error where that fails; what was written by then stays.

/// Linear radiance as 16-bit floats, channels R, G and B; beside them Z as 32-bit floats unless `metres`
/// is null.
void writeRadianceExr(const std::filesystem::path& path, glm::ivec2 size,
                      const std::vector<glm::vec3>& radiance, const std::vector<float>* metres);

/// Reads channels R, G and B of a file. Throws std::runtime_error where one is missing.
std::vector<glm::vec3> readRadianceExr(const std::filesystem::path& path, glm::ivec2& size);

/// 32-bit floats: one channel, Z: metres, +inf where there is nothing.
void writeDepthExr(const std::filesystem::path& path, glm::ivec2 size,
                   const std::vector<float>& metres);

/// 32-bit floats: three channels, N.X, N.Y, N.Z.
void writeNormalsExr(const std::filesystem::path& path, glm::ivec2 size,
                     const std::vector<glm::vec3>& normals);

/// Reads channel Z of a file. Throws std::runtime_error where there is none.
std::vector<float> readDepthExr(const std::filesystem::path& path, glm::ivec2& size);

}  // namespace seaway::render
