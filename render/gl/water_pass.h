#pragma once

#include <cstddef>

#include "render/gl/buffers.h"
#include "render/sea_grid.h"

namespace seaway::render {

/// Draws a SeaGrid into the geometry framebuffer, which must be bound.
class WaterPass {
 public:
  WaterPass();
  void draw(const SeaGrid& grid, const glm::mat4& clipFromRelativeWorld, bool cameraIsUnderWater);
  std::size_t memoryBytes() const { return vertices_.memoryBytes() + indices_.memoryBytes(); }

 private:
  GlProgram program_;
  GlGrowingBuffer vertices_, indices_;
  GlVertexArray array_;
};

}  // namespace seaway::render
