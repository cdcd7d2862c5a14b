#pragma once

#include <glm/vec2.hpp>

#include "render/gl/gl_objects.h"

namespace seaway::render {

/// Triangles of a whole grid, two a cell, counter-clockwise seen from above, in strips of columns
/// so narrow that a row of a strip is still in the vertex cache when the next one needs it.
class GridIndices {
 public:
  /// Makes them for a grid of `size` vertices, ≥ 2 each; keeps those it has.
  void prepare(glm::ivec2 size);

  GLuint buffer() const { return buffer_; }
  GLsizei count() const;
  std::size_t memoryBytes() const { return static_cast<std::size_t>(count()) * 4; }

 private:
  GlBuffer buffer_;
  glm::ivec2 size_{1};
};

}  // namespace seaway::render
