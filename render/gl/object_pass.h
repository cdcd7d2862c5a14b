#pragma once

#include <cstddef>
#include <span>

#include "render/gl/buffers.h"
#include "render/render_technique.h"

namespace seaway::render {

/// Draws scene objects into the geometry framebuffer, which must be bound. Their number among the
/// objects, from 1 on, is what `albedo` has as alpha, in 255ths; 255 from there on.
class ObjectPass {
 public:
  static constexpr std::size_t mostTold = 254;
  ObjectPass();
  void draw(std::span<const SceneObject> objects, const Camera& camera,
            const glm::mat4& clipFromRelativeWorld);
  std::size_t memoryBytes() const { return vertices_.memoryBytes(); }

 private:
  GlProgram program_;
  GlGrowingBuffer vertices_;  // of one mesh at a time: a mesh may change between frames
  GlVertexArray array_;
};

}  // namespace seaway::render
