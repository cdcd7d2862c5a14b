#include "render/frame.h"

namespace seaway::render {

void prepare(Frame& frame, glm::ivec2 size, const FrameContents& contents) {
  const std::size_t pixels = static_cast<std::size_t>(size.x) * size.y;
  frame.colour.size = frame.depth.size = size;
  frame.colour.rgb.resize(3 * pixels);
  frame.depth.metres.resize(pixels);
  frame.classes.resize(pixels);
  frame.normals.resize(contents.normals ? pixels : 0);
  frame.radiance.resize(contents.radiance ? pixels : 0);
  frame.instances.resize(contents.labels ? pixels : 0);
  frame.foam.resize(contents.labels ? pixels : 0);
  frame.stats = {};
}

}  // namespace seaway::render
