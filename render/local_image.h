#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "render/cover_tiles.h"

namespace seaway::render {

/// A piece of a picture that holds the light of scene objects alone; row by row from the top left.
struct LocalImage {
  glm::ivec2 least{0}, size{0};  ///< of its box of pixels; (0, 0): there is nothing
  /// Linear radiance, RGB9E5 (exact to 1/512 of the largest of the three); 0 where there is
  /// nothing, and only there.
  std::vector<std::uint32_t> light;
  std::vector<float> nearness;  ///< 1/axial distance, m⁻¹; 0 where there is nothing
  CoverTiles tiles;             ///< of nearness; filled in where rays are followed

  bool empty() const { return size.x <= 0 || size.y <= 0; }
  void resize() {
    light.resize(static_cast<std::size_t>(size.x) * size.y);
    nearness.resize(light.size());
  }
  std::size_t memoryBytes() const {
    return light.capacity() * sizeof(std::uint32_t) + nearness.capacity() * sizeof(float) +
           tiles.memoryBytes();
  }
  glm::vec3 radiance(std::size_t i) const {
    const std::uint32_t word = light[i];
    // Mantissas times 2^(exponent − 24).
    const auto scale = std::bit_cast<float>(((word >> 27) + 127u - 24u) << 23);
    return glm::vec3(word & 511u, word >> 9 & 511u, word >> 18 & 511u) * scale;
  }
};

}  // namespace seaway::render
