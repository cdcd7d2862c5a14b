#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

namespace seaway::render {

/// Which parts of an image hold anything: answers for a box of any size at the cost of four
/// numbers, so that nobody looks for what is not there.
class CoverTiles {
 public:
  static constexpr int side = 8;  ///< texels of a tile

  /// Of numbers row by row, `stride` apart, of which 0 stands for nothing.
  void fill(const float* values, glm::ivec2 size, std::size_t stride);

  /// False only where no texel of the box, its last column and row included, holds anything. The
  /// box may be anywhere. True as long as nothing has been filled in.
  bool mayHold(glm::ivec2 first, glm::ivec2 last) const;

  std::size_t memoryBytes() const { return sums_.capacity() * sizeof(std::uint32_t); }

 private:
  glm::ivec2 tiles_{0};
  /// Numbers of tiles that hold something, of those left of and above a corner of tiles.
  std::vector<std::uint32_t> sums_;
};

}  // namespace seaway::render
