#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <vector>

namespace seaway::render {

/// A piece of a picture that holds the light of scene objects alone.
struct LocalImage {
  glm::ivec2 least{0}, size{0};  ///< of its box of pixels; (0, 0): there is nothing
  /// Linear radiance, and 1/axial distance in m⁻¹, 0 where there is nothing; row by row from the
  /// top left.
  std::vector<glm::vec4> texels;

  bool empty() const { return size.x <= 0 || size.y <= 0; }
};

}  // namespace seaway::render
