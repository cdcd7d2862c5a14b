#include "render/gl/sea_mesh.h"

#include <tbb/parallel_for.h>

#include <cmath>
#include <glm/geometric.hpp>

namespace seaway::render {
namespace {

/// Sides of the camera's frustum that a point lies beyond, one bit each.
class FrustumSides {
 public:
  explicit FrustumSides(const Camera& camera)
      : forward_(camera.forward()),
        right_(-camera.left() - camera.pictureMiddle().x * camera.forward()),
        up_(camera.up() - camera.pictureMiddle().y * camera.forward()),
        tanY_(static_cast<float>(camera.halfPicture().y)),
        tanX_(static_cast<float>(camera.halfPicture().x)),
        nearest_(static_cast<float>(camera.nearDistance)) {}

  std::uint8_t beyond(glm::vec3 p) const {
    const float axial = glm::dot(p, forward_), x = glm::dot(p, right_), y = glm::dot(p, up_);
    return static_cast<std::uint8_t>((axial < nearest_) | (x < -tanX_ * axial) << 1 |
                                     (x > tanX_ * axial) << 2 | (y < -tanY_ * axial) << 3 |
                                     (y > tanY_ * axial) << 4);
  }

 private:
  glm::vec3 forward_, right_, up_;
  float tanY_, tanX_, nearest_;
};

}  // namespace

void SeaMesh::fill(const SeaGrid& grid, const Camera& camera) {
  const glm::ivec2 size = grid.size();
  vertices_.resize(grid.vertexCount());
  outside_.resize(grid.vertexCount());
  const FrustumSides sides(camera);
  tbb::parallel_for(0, size.y, [&](int row) {
    for (int column = 0; column < size.x; ++column) {
      const std::size_t i = static_cast<std::size_t>(row) * size.x + column;
      vertices_[i] = {
          {grid.x()[i], grid.y()[i], grid.z()[i]},
          {grid.slopeX()[i], grid.slopeY()[i]},
          grid.height()[i],
          grid.missingSlope()[row] + (grid.missingWakes().empty() ? 0.0f : grid.missingWakes()[i]),
          grid.cover().empty() ? 0u : grid.cover()[i]};
      outside_[i] = sides.beyond(vertices_[i].position);
    }
  });
  indices_.clear();
  for (int row = 0; row + 1 < size.y; ++row) {
    for (int column = 0; column + 1 < size.x; ++column) {
      if (!grid.mayShow(row, column / SeaGrid::batch)) continue;
      const auto a = static_cast<std::uint32_t>(row * size.x + column);
      const std::uint32_t b = a + 1, c = a + size.x, d = c + 1;
      if (outside_[a] & outside_[b] & outside_[c] & outside_[d]) continue;
      indices_.insert(indices_.end(), {a, b, c, b, d, c});  // counter-clockwise from above
    }
  }
}

std::size_t SeaMesh::memoryBytes() const {
  return vertices_.capacity() * sizeof(SeaVertex) + indices_.capacity() * sizeof(std::uint32_t) +
         outside_.capacity();
}

}  // namespace seaway::render
