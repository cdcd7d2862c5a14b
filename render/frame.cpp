#include "render/frame.h"

namespace seaway::render {

void prepare(Frame& frame, glm::ivec2 size, bool withNormals) {
  const std::size_t pixels = static_cast<std::size_t>(size.x) * size.y;
  frame.colour.size = frame.depth.size = size;
  frame.colour.rgb.resize(3 * pixels);
  frame.depth.metres.resize(pixels);
  frame.classes.resize(pixels);
  frame.normals.resize(withNormals ? pixels : 0);
  frame.stats = {};
}

}  // namespace seaway::render
