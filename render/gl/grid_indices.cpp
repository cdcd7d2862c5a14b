#include "render/gl/grid_indices.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace seaway::render {

GLsizei GridIndices::count() const { return 6 * (size_.x - 1) * (size_.y - 1); }

void GridIndices::prepare(glm::ivec2 size) {
  if (size == size_) return;
  constexpr int stripCells = 15;
  size_ = size;
  std::vector<std::uint32_t> indices;
  indices.reserve(static_cast<std::size_t>(count()));
  for (int first = 0; first + 1 < size.x; first += stripCells) {
    const int end = std::min(first + stripCells, size.x - 1);
    for (int row = 0; row + 1 < size.y; ++row) {
      for (int column = first; column < end; ++column) {
        const auto a = static_cast<std::uint32_t>(row * size.x + column);
        const std::uint32_t b = a + 1, c = a + static_cast<std::uint32_t>(size.x), d = c + 1;
        indices.insert(indices.end(), {a, b, c, b, d, c});
      }
    }
  }
  buffer_ = makeBuffer();  // storage is immutable: another size needs another buffer
  glNamedBufferStorage(buffer_, static_cast<GLsizeiptr>(indices.size() * sizeof(std::uint32_t)),
                       indices.data(), 0);
}

}  // namespace seaway::render
