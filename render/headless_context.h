#pragma once

#include <memory>
#include <string>
#include <vector>

namespace seaway::render {

/// An OpenGL context without a window. One per thread that draws. Contexts of different backends
/// may live together, but must not draw in two threads at the same time: OpenGL's functions are
/// looked up anew when the backend changes.
class HeadlessContext {
 public:
  virtual ~HeadlessContext() = default;

  /// Makes the context current on the calling thread, after releasing the one that was. Throws
  /// std::runtime_error if it cannot.
  virtual void makeCurrent() = 0;

  virtual std::string backend() const = 0;   ///< as asked for: "osmesa", "egl", "egl:0"
  virtual std::string renderer() const = 0;  ///< GL_RENDERER
  virtual std::string version() const = 0;   ///< GL_VERSION

  /// Largest width or height of a framebuffer, pixels.
  virtual int maximumSize() const = 0;

  /// Whether a processor draws, not a graphics card: what is quick on one is slow on the other.
  virtual bool isSoftware() const = 0;
};

/// Makes a context with OpenGL 4.5 core, current and loaded, of the backend
///
///   "osmesa"  Mesa's software renderer, where its library is installed,
///   "egl"     EGL without a surface: what Mesa finds best; where there is no Mesa, the first EGL
///             device that offers OpenGL 4.5,
///   "egl:N"   EGL device number N.
///
/// Throws InputError for a name that is none of these or a device that is not there,
/// std::runtime_error where the backend does not start; both name what this machine offers.
std::unique_ptr<HeadlessContext> makeHeadlessContext(const std::string& backend = "osmesa");

/// Throws InputError unless `backend` is one of the forms above and its device is there; starts
/// nothing.
void requireBackend(const std::string& backend);

/// What this machine offers: "osmesa", "egl", "egl:0" …. A device that is listed may still lack
/// OpenGL 4.5.
std::vector<std::string> headlessBackends();

}  // namespace seaway::render
