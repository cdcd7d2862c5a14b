#pragma once

#include <memory>
#include <string>

namespace seaway::render {

/// An OpenGL context without a window. One per thread that draws.
class HeadlessContext {
 public:
  virtual ~HeadlessContext() = default;

  /// Makes the context current on the calling thread. Throws std::runtime_error if it cannot.
  virtual void makeCurrent() = 0;

  virtual std::string backend() const = 0;   ///< "osmesa"
  virtual std::string renderer() const = 0;  ///< GL_RENDERER
  virtual std::string version() const = 0;   ///< GL_VERSION

  /// Largest width or height of a framebuffer, pixels.
  virtual int maximumSize() const = 0;
};

/// Makes a context of the named backend ("osmesa") with OpenGL 4.5 core, current and loaded.
/// Throws InputError for an unknown name, std::runtime_error where the backend does not start.
std::unique_ptr<HeadlessContext> makeHeadlessContext(const std::string& backend = "osmesa");

}  // namespace seaway::render
