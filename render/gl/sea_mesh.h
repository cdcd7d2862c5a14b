#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "render/sea_grid.h"

namespace seaway::render {

/// A vertex of the drawn sea, as it goes into the vertex buffer.
struct SeaVertex {
  glm::vec3 position;         ///< relative to the camera, sea-plane axes, curved sea, m
  glm::vec2 slope;            ///< of the waves the grid carries
  float height = 0.0f;        ///< of the waves above still water, m
  float missingSlope = 0.0f;  ///< mean-square slope that the grid does not carry
  std::uint32_t cover = 0;    ///< foam, smoothed water and oil in the low three bytes
};

/// A SeaGrid as a mesh for OpenGL: its vertices and the triangles that can be in the picture.
class SeaMesh {
 public:
  void fill(const SeaGrid& grid, const Camera& camera);

  const std::vector<SeaVertex>& vertices() const { return vertices_; }
  const std::vector<std::uint32_t>& indices() const { return indices_; }
  std::size_t memoryBytes() const;

 private:
  std::vector<SeaVertex> vertices_;
  std::vector<std::uint32_t> indices_;
  std::vector<std::uint8_t> outside_;  // bits: behind the near plane, left, right, below, above
};

}  // namespace seaway::render
