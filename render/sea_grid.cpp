#include "render/sea_grid.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "surface/curvature.h"

namespace seaway::render {
double gridSpacing(const Projector& projector, const std::vector<double>& rows, int row,
                   int columns) {
  const int neighbour = row + 1 < static_cast<int>(rows.size()) ? row + 1 : row - 1;
  const glm::dvec2 here = projector.basePoint(0.5, rows[row]);
  const glm::dvec2 beside = projector.basePoint(0.5 + 1.0 / (columns - 1), rows[row]);
  const glm::dvec2 beyond = projector.basePoint(0.5, rows[neighbour]);
  return std::max({glm::distance(here, beside), glm::distance(here, beyond), 1e-9});
}

void SeaGrid::fill(const WaterSurface& water, double time, const Camera& camera,
                   const Projector& projector, glm::ivec2 size) {
  size_ = size;
  const std::size_t count = static_cast<std::size_t>(size.x) * size.y;
  vertices_.resize(count);
  for (auto* row : {&base_, &points_}) row->resize(size.x);
  for (auto* row : {&full_, &partial_}) row->resize(size.x);
  largestHeight_ = 0.0;

  const BandLimit bandLimit(water.waves());
  const std::vector<double> rows = projector.rows(size.y);
  for (int row = 0; row < size.y; ++row) {
    for (int column = 0; column < size.x; ++column) {
      const double u = static_cast<double>(column) / (size.x - 1);
      base_[column] = projector.basePoint(u, rows[row]);
      points_[column] = glm::dvec2(camera.position) + base_[column];
    }
    const double spacing = gridSpacing(projector, rows, row, size.x);
    fillRow(water, time, camera, bandLimit.planFor(spacing), row);
  }
  markOutside(camera);
  connectVisible();
}

void SeaGrid::fillRow(const WaterSurface& water, double time, const Camera& camera,
                      const BandLimit::Plan& plan, int row) {
  const bool fades = plan.weight > 0.0;
  water.sample(points_, time, partial_, {.shortestWavelength = plan.keptWavelength});
  if (fades) water.sample(points_, time, full_, {.shortestWavelength = plan.fadingWavelength});
  SeaVertex* vertex = vertices_.data() + static_cast<std::size_t>(row) * size_.x;
  for (int column = 0; column < size_.x; ++column, ++vertex) {
    const SurfaceSample& partial = partial_[column];
    const SurfaceSample& full = fades ? full_[column] : partial;
    double height = glm::mix(partial.height, full.height, plan.weight);
    glm::dvec2 slope = glm::mix(partial.slope, full.slope, plan.weight);
    // Where the field has no answer the sea is drawn still: a hole would look like sky.
    if (!std::isfinite(height)) height = 0.0, slope = glm::dvec2(0.0);
    largestHeight_ = std::max(largestHeight_, std::abs(height));
    const glm::dvec2 base = base_[column];
    const double z = height - seaDrop(glm::length(base)) - camera.position.z;
    *vertex = {glm::vec3(base.x, base.y, z), glm::vec2(slope), static_cast<float>(height),
               static_cast<float>(plan.missingSlope)};
  }
}

void SeaGrid::markOutside(const Camera& camera) {
  const double halfHeight = std::tan(0.5 * camera.verticalFieldOfView);
  const glm::vec3 forward(camera.forward()), right(-camera.left()), up(camera.up());
  const float tanY = static_cast<float>(halfHeight);
  const float tanX = static_cast<float>(halfHeight * camera.aspectRatio());
  const float nearest = static_cast<float>(camera.nearDistance);
  outside_.resize(vertices_.size());
  verticesInFrustum_ = 0;
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    const glm::vec3 p = vertices_[i].position;
    const float axial = glm::dot(p, forward), x = glm::dot(p, right), y = glm::dot(p, up);
    const int bits = (axial < nearest) | (x < -tanX * axial) << 1 | (x > tanX * axial) << 2 |
                     (y < -tanY * axial) << 3 | (y > tanY * axial) << 4;
    outside_[i] = static_cast<std::uint8_t>(bits);
    verticesInFrustum_ += bits == 0;
  }
}

void SeaGrid::connectVisible() {
  indices_.clear();
  for (int row = 0; row + 1 < size_.y; ++row) {
    for (int column = 0; column + 1 < size_.x; ++column) {
      const auto a = static_cast<std::uint32_t>(row * size_.x + column);
      const std::uint32_t b = a + 1, c = a + size_.x, d = c + 1;
      if (outside_[a] & outside_[b] & outside_[c] & outside_[d]) continue;
      indices_.insert(indices_.end(), {a, b, c, b, d, c});  // counter-clockwise from above
    }
  }
}

std::size_t SeaGrid::memoryBytes() const {
  return vertices_.capacity() * sizeof(SeaVertex) + indices_.capacity() * sizeof(std::uint32_t) +
         outside_.capacity() + (base_.capacity() + points_.capacity()) * sizeof(glm::dvec2) +
         (full_.capacity() + partial_.capacity()) * sizeof(SurfaceSample);
}

}  // namespace seaway::render
