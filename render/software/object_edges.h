#pragma once

#include <bit>
#include <cstdint>
#include <vector>

#include "render/software/object_triangles.h"

namespace seaway::render {

/// How much of each pixel of a strip objects cover, from eight samples spread over it: what is
/// thinner than a pixel, such as a mast far away, becomes a faint line where centres of pixels
/// alone would make dots of it.
class ObjectEdges {
 public:
  static constexpr int samples = 8;

  /// To be called when the strip holds the sea alone. Looks only where objects may be. The sea and
  /// each triangle have one depth a pixel, that of its centre.
  void fill(const ObjectTriangles& objects, const Strip& sea);

  /// Columns [left, right) that objects may touch.
  int left() const { return left_; }
  int right() const { return right_; }

  /// Of a row of the strip, from column `left` on: 1/axial distance of the sea, samples that show
  /// an object (one bit each), and the nearest object with its 1/axial distance.
  struct Row {
    const float* sea;
    const std::uint8_t* covering;
    const std::uint32_t* object;
    const float* inverse;

    int covered(int i) const { return std::popcount(covering[i]); }
  };
  Row row(int line) const;

  std::size_t memoryBytes() const;

 private:
  class Planes;
  void cover(const ScreenTriangle& triangle);
  void coverRow(const Planes& planes, int line, std::uint32_t object);

  int left_ = 0, right_ = 0, top_ = 0, rows_ = 0, stride_ = 0;
  std::vector<float> sea_, inverse_;
  std::vector<std::uint8_t> covering_;
  std::vector<std::uint32_t> object_;
};

}  // namespace seaway::render
