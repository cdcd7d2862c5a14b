#include "render/cover_tiles.h"

#include <algorithm>
#include <glm/common.hpp>

namespace seaway::render {

void CoverTiles::fill(const float* values, glm::ivec2 size, std::size_t stride) {
  tiles_ = (size + (side - 1)) / side;
  const std::size_t across = static_cast<std::size_t>(tiles_.x) + 1;
  sums_.assign(across * (static_cast<std::size_t>(tiles_.y) + 1), 0u);
  std::vector<std::uint8_t> holds(static_cast<std::size_t>(tiles_.x) * side);
  for (int tileY = 0; tileY < tiles_.y; ++tileY) {
    std::fill(holds.begin(), holds.end(), std::uint8_t{0});
    for (int y = tileY * side; y < std::min((tileY + 1) * side, size.y); ++y) {
      const float* const row = values + static_cast<std::size_t>(y) * stride;
      for (int x = 0; x < size.x; ++x) holds[x] |= static_cast<std::uint8_t>(row[x] != 0.0f);
    }
    std::uint32_t inRow = 0;
    for (int tileX = 0; tileX < tiles_.x; ++tileX) {
      const auto first = holds.begin() + static_cast<std::ptrdiff_t>(tileX) * side;
      inRow += std::find(first, first + side, std::uint8_t{1}) != first + side;
      const std::size_t at = across * (tileY + 1) + tileX + 1;
      sums_[at] = sums_[at - across] + inRow;
    }
  }
}

bool CoverTiles::mayHold(glm::ivec2 first, glm::ivec2 last) const {
  if (sums_.empty()) return true;
  const glm::ivec2 none(0), end = tiles_ * side;
  if (last.x < first.x || last.y < first.y) return false;
  const glm::ivec2 from = glm::clamp(first, none, end) / side;
  const glm::ivec2 to = (glm::clamp(last + 1, none, end) + (side - 1)) / side;
  const std::size_t across = static_cast<std::size_t>(tiles_.x) + 1;
  const auto sum = [&](int x, int y) { return sums_[across * y + x]; };
  return sum(to.x, to.y) + sum(from.x, from.y) > sum(from.x, to.y) + sum(to.x, from.y);
}

}  // namespace seaway::render
