// This file does not include glad: osmesa.h brings GL/gl.h, and the two define the same names.
#include "render/osmesa_context.h"

#include <GL/osmesa.h>
#include <dlfcn.h>

#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <type_traits>

#include "render/loaded_context.h"

#if defined(__SANITIZE_ADDRESS__)
// OSMesa keeps its framebuffer records, about a kilobyte, until the process ends.
extern "C" const char* __lsan_default_suppressions() { return "leak:libOSMesa"; }
#endif

namespace seaway::render {
namespace {

/// OSMesa's functions, looked up when first needed: newer Mesa has no OSMesa any more, and what
/// draws through EGL shall not need it.
struct Osmesa {
  Osmesa() {
    void* library = dlopen("libOSMesa.so.8", RTLD_LAZY | RTLD_LOCAL);
    if (!library) throw std::runtime_error(std::string("OSMesa is not installed: ") + dlerror());
    const auto find = [&](auto& function, const char* name) {
      function =
          reinterpret_cast<std::remove_reference_t<decltype(function)>>(dlsym(library, name));
      if (!function) throw std::runtime_error(std::string("OSMesa lacks ") + name);
    };
    find(createContext, "OSMesaCreateContextAttribs");
    find(destroyContext, "OSMesaDestroyContext");
    find(makeCurrent, "OSMesaMakeCurrent");
    find(getProcAddress, "OSMesaGetProcAddress");
  }
  decltype(&OSMesaCreateContextAttribs) createContext;
  decltype(&OSMesaDestroyContext) destroyContext;
  decltype(&OSMesaMakeCurrent) makeCurrent;
  decltype(&OSMesaGetProcAddress) getProcAddress;
};

const Osmesa& osmesa() {
  static const Osmesa functions;
  return functions;
}

class OsmesaContext final : public LoadedContext {
 public:
  OsmesaContext() : LoadedContext(osmesa().getProcAddress) {
    const int attributes[] = {OSMESA_FORMAT,
                              OSMESA_RGBA,
                              OSMESA_PROFILE,
                              OSMESA_CORE_PROFILE,
                              OSMESA_CONTEXT_MAJOR_VERSION,
                              4,
                              OSMESA_CONTEXT_MINOR_VERSION,
                              5,
                              0};
    context_ = osmesa().createContext(attributes, nullptr);
    if (!context_) throw std::runtime_error("OSMesa offers no OpenGL 4.5 core context");
    try {
      load();
    } catch (...) {
      destroy();
      throw;
    }
  }
  ~OsmesaContext() override { destroy(); }
  OsmesaContext(const OsmesaContext&) = delete;
  OsmesaContext& operator=(const OsmesaContext&) = delete;

  std::string backend() const override { return "osmesa"; }

 private:
  void bind() override {
    if (!osmesa().makeCurrent(context_, unused_.data(), GL_UNSIGNED_BYTE, side, side)) {
      throw std::runtime_error("OSMesa context cannot be made current");
    }
  }
  void unbind() noexcept override { osmesa().makeCurrent(nullptr, nullptr, 0, 0, 0); }
  void destroy() {
    release();
    osmesa().destroyContext(context_);
  }

  static constexpr int side = 4;
  OSMesaContext context_ = nullptr;
  // OSMesa insists on a default framebuffer; all drawing goes into framebuffers of our own.
  std::array<std::uint8_t, 4 * side * side> unused_{};
};

}  // namespace

bool osmesaIsInstalled() {
  try {
    osmesa();
    return true;
  } catch (const std::runtime_error&) {
    return false;
  }
}

std::unique_ptr<HeadlessContext> makeOsmesaContext() { return std::make_unique<OsmesaContext>(); }

}  // namespace seaway::render
