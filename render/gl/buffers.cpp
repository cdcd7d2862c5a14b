#include "render/gl/buffers.h"

namespace seaway::render {

void GlGrowingBuffer::putBytes(const void* data, std::size_t bytes) {
  if (bytes > capacity_) {
    capacity_ = bytes + bytes / 4;
    glNamedBufferData(name_, static_cast<GLsizeiptr>(capacity_), nullptr, GL_STREAM_DRAW);
  }
  if (bytes > 0) glNamedBufferSubData(name_, 0, static_cast<GLsizeiptr>(bytes), data);
}

void byteAttribute(GLuint vertexArray, GLuint index, std::size_t offset) {
  glEnableVertexArrayAttrib(vertexArray, index);
  glVertexArrayAttribFormat(vertexArray, index, 3, GL_UNSIGNED_BYTE, GL_TRUE,
                            static_cast<GLuint>(offset));
  glVertexArrayAttribBinding(vertexArray, index, 0);
}

void floatAttribute(GLuint vertexArray, GLuint index, int components, std::size_t offset) {
  glEnableVertexArrayAttrib(vertexArray, index);
  glVertexArrayAttribFormat(vertexArray, index, components, GL_FLOAT, GL_FALSE,
                            static_cast<GLuint>(offset));
  glVertexArrayAttribBinding(vertexArray, index, 0);
}

}  // namespace seaway::render
