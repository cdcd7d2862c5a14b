#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <span>

#include "render/field_twin.h"
#include "render/gl/gl_objects.h"

namespace seaway::render {

/// What is added to the wave map, a texel for each of its own (RGBA32F): height, slope, and the
/// mean-square slope that rows do not carry.
class StampMap {
 public:
  /// Clears the map for a grid of `size` and makes it what is drawn to, adding up.
  void begin(glm::ivec2 size);
  void end();
  GLuint texture() const { return texture_; }
  std::size_t memoryBytes() const { return static_cast<std::size_t>(size_.x) * size_.y * 16; }

 private:
  GlTexture texture_;
  GlFramebuffer framebuffer_;
  glm::ivec2 size_{0};
};

/// Texels, first column and row and one past the last of each, whose points may lie within `reach`
/// m of `centre` (m from the camera's foot); nothing where there are none.
std::optional<glm::vec4> texelsAround(glm::vec2 centre, float reach, std::span<const TwinRow> rows,
                                      int columns);

}  // namespace seaway::render
