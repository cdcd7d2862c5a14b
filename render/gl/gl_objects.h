#pragma once

#include <glad/gl.h>

#include <glm/fwd.hpp>
#include <glm/mat2x2.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <initializer_list>
#include <map>
#include <string>
#include <string_view>
#include <utility>

/// Owners of OpenGL names: made when constructed, deleted with the object. The context they were
/// made in must be current in both. Only sources of render/ include this.
namespace seaway::render {

template <void (*release)(GLuint)>
class GlName {
 public:
  GlName() = default;
  explicit GlName(GLuint name) : name_(name) {}
  GlName(GlName&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
  GlName& operator=(GlName&& other) noexcept {
    std::swap(name_, other.name_);
    return *this;
  }
  ~GlName() {
    if (name_ != 0) release(name_);
  }
  operator GLuint() const { return name_; }

 private:
  GLuint name_ = 0;
};

inline void releaseTexture(GLuint name) { glDeleteTextures(1, &name); }
inline void releaseBuffer(GLuint name) { glDeleteBuffers(1, &name); }
inline void releaseFramebuffer(GLuint name) { glDeleteFramebuffers(1, &name); }
inline void releaseVertexArray(GLuint name) { glDeleteVertexArrays(1, &name); }
inline void releaseProgram(GLuint name) { glDeleteProgram(name); }

using GlTexture = GlName<&releaseTexture>;
using GlBuffer = GlName<&releaseBuffer>;
using GlFramebuffer = GlName<&releaseFramebuffer>;
using GlVertexArray = GlName<&releaseVertexArray>;

GlBuffer makeBuffer();
GlVertexArray makeVertexArray();

/// Immutable 2-D texture, clamped to its edge; `levels` > 1 filters between mip levels.
GlTexture makeTexture(GLenum format, glm::ivec2 size, GLenum filter, int levels = 1);

/// Framebuffer with the given colour attachments and, if not 0, a depth and stencil
/// attachment.
/// Throws std::runtime_error if it is not complete.
GlFramebuffer makeFramebuffer(std::initializer_list<GLuint> colours, GLuint depth = 0);

/// Names of embedded shaders whose texts are joined to one. In all of them `exact` keeps arithmetic
/// as written where the renderer's is to equal the processor's, and lets a graphics card fuse it.
using ShaderParts = std::initializer_list<std::string_view>;

/// A vertex and a fragment shader, linked.
class GlProgram {
 public:
  GlProgram() = default;
  /// Throws std::runtime_error with the compiler's log.
  GlProgram(ShaderParts vertex, ShaderParts fragment);
  /// A compute program of its own. Throws as above.
  static GlProgram compute(ShaderParts parts);

  operator GLuint() const { return name_; }

  /// Uniforms that the shader does not use are ignored.
  void set(const char* name, int value) const;
  void set(const char* name, float value) const;
  void set(const char* name, glm::vec2 value) const;
  void set(const char* name, glm::vec3 value) const;
  void set(const char* name, glm::vec4 value) const;
  void set(const char* name, const glm::mat2& value) const;
  void set(const char* name, const glm::mat3& value) const;
  void set(const char* name, const glm::mat4& value) const;
  /// Binds `texture` to `unit` and points the sampler `name` at it.
  void setTexture(const char* name, GLuint unit, GLuint texture) const;

  void set(const char* name, glm::ivec2 value) const;

 private:
  void link();
  GLint location(const char* name) const;
  GlName<&releaseProgram> name_;
  mutable std::map<std::string, GLint, std::less<>> locations_;  // drivers are slow to look up
};

/// Throws std::runtime_error naming the place if OpenGL recorded an error.
void checkGl(const char* place);

}  // namespace seaway::render
