#pragma once

#include <glm/vec2.hpp>

namespace seaway::render {

/// A rectangle of a picture's pixels, from the top left; empty where end <= least.
struct PixelBox {
  glm::ivec2 least{0}, end{0};
};

}  // namespace seaway::render
