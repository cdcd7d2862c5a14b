#pragma once

#include <cstddef>
#include <span>

#include "render/gl/gl_objects.h"

namespace seaway::render {

/// A buffer that grows with what is put in it.
class GlGrowingBuffer {
 public:
  GlGrowingBuffer() : name_(makeBuffer()) {}
  operator GLuint() const { return name_; }

  template <typename Item>
  void put(std::span<const Item> items) {
    putBytes(items.data(), items.size_bytes());
  }
  std::size_t memoryBytes() const { return capacity_; }

 private:
  void putBytes(const void* data, std::size_t bytes);

  GlBuffer name_;
  std::size_t capacity_ = 0;
};

/// Describes attribute `index` of the buffer at binding 0: `components` floats at `offset` bytes.
/// Three bytes of a 32-bit word as numbers of [0, 1].
void byteAttribute(GLuint vertexArray, GLuint index, std::size_t offset);

void floatAttribute(GLuint vertexArray, GLuint index, int components, std::size_t offset);

}  // namespace seaway::render
