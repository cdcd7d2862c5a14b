#include "render/software/screen_grid.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace seaway::render {
namespace {

static_assert(quadsPerBatch == SeaGrid::batch);

constexpr float farBeside = 8192.0f;  // pixels: beyond, float edges lose a tenth of a pixel

}  // namespace

void ScreenGrid::fill(const SeaGrid& grid, const Camera& camera) {
  size_ = grid.size();
  batchesPerRow_ = (size_.x - 1 + quadsPerBatch - 1) / quadsPerBatch;
  for (auto* values : {&x_, &y_, &inverse_}) values->resize(grid.vertexCount() + 32);
  extents_.resize(static_cast<std::size_t>(batchesPerRow_) * (size_.y - 1));
  const ScreenProjection projection(camera);
  tbb::parallel_for(0, size_.y, [&](int row) {
    const std::size_t first = static_cast<std::size_t>(row) * size_.x;
    const float *x = grid.x().data() + first, *y = grid.y().data() + first,
                *z = grid.z().data() + first;
    float *toX = x_.data() + first, *toY = y_.data() + first, *toInverse = inverse_.data() + first;
    const glm::vec3 f = projection.forward, r = projection.right, d = projection.down;
    for (int i = 0; i < size_.x; ++i) {
      const float axial = x[i] * f.x + y[i] * f.y + z[i] * f.z;
      const float inverse = axial >= projection.nearest ? 1.0f / axial : 0.0f;
      toInverse[i] = inverse;
      toX[i] = (x[i] * r.x + y[i] * r.y + z[i] * r.z) * inverse + projection.middle.x;
      toY[i] = (x[i] * d.x + y[i] * d.y + z[i] * d.z) * inverse + projection.middle.y;
    }
  });
  isClipped_.assign(extents_.size(), 0);
  tbb::parallel_for(0, size_.y - 1, [&](int row) {
    for (int batch = 0; batch < batchesPerRow_; ++batch) {
      const std::size_t at = static_cast<std::size_t>(row) * batchesPerRow_ + batch;
      extents_[at] = {1.0f, 0.0f};
      if (!grid.mayShow(row, batch)) continue;
      isClipped_[at] = extentOf(row, batch, camera.size, extents_[at]) == Fate::clipped;
    }
  });
  clipped_.clear();
  for (std::size_t at = 0; at < isClipped_.size(); ++at) {
    const int batch = static_cast<int>(at) % batchesPerRow_;
    if (isClipped_[at]) clip(grid, projection, static_cast<int>(at) / batchesPerRow_, batch);
  }
}

ScreenGrid::Fate ScreenGrid::extentOf(int row, int batch, glm::ivec2 picture,
                                      Extent& extent) const {
  const int first = batch * quadsPerBatch, last = std::min(first + quadsPerBatch, size_.x - 1);
  float left = 1e30f, right = -1e30f, top = 1e30f, bottom = -1e30f, least = 1e30f, most = 0.0f;
  for (int line = row; line <= row + 1; ++line) {
    const std::size_t at = static_cast<std::size_t>(line) * size_.x;
    for (int column = first; column <= last; ++column) {
      left = std::min(left, x_[at + column]);
      right = std::max(right, x_[at + column]);
      top = std::min(top, y_[at + column]);
      bottom = std::max(bottom, y_[at + column]);
      least = std::min(least, inverse_[at + column]);
      most = std::max(most, inverse_[at + column]);
    }
  }
  extent = {1.0f, 0.0f};
  if (most == 0.0f) return Fate::empty;
  if (least == 0.0f) return Fate::clipped;
  if (right < 0.0f || left > static_cast<float>(picture.x) || bottom < 0.0f ||
      top > static_cast<float>(picture.y)) {
    return Fate::empty;
  }
  if (std::max({-left, right, -top, bottom}) > farBeside) return Fate::clipped;
  extent = {top, bottom};
  return Fate::drawn;
}

void ScreenGrid::clip(const SeaGrid& grid, const ScreenProjection& projection, int row, int batch) {
  const int first = batch * quadsPerBatch, last = std::min(first + quadsPerBatch, size_.x - 1);
  const auto corner = [&](std::size_t i) {
    return glm::vec3(grid.x()[i], grid.y()[i], grid.z()[i]);
  };
  const std::size_t across = size_.x;
  for (int column = first; column < last; ++column) {
    const std::size_t a = static_cast<std::size_t>(row) * across + column;
    const glm::vec3 corners[2][3] = {{corner(a), corner(a + 1), corner(a + across)},
                                     {corner(a + 1), corner(a + across + 1), corner(a + across)}};
    ScreenTriangle projected[2];
    for (const auto& triangle : corners) {
      const int count = projectTriangle(triangle, projection, projected);
      clipped_.insert(clipped_.end(), projected, projected + count);
    }
  }
}

std::size_t ScreenGrid::memoryBytes() const {
  return (x_.capacity() + y_.capacity() + inverse_.capacity()) * sizeof(float) +
         extents_.capacity() * sizeof(Extent) + isClipped_.capacity() +
         clipped_.capacity() * sizeof(ScreenTriangle);
}

}  // namespace seaway::render
