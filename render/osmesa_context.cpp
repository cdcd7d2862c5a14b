// This file does not include glad: osmesa.h brings GL/gl.h, and the two define the same names.
#include "render/osmesa_context.h"

#include <GL/osmesa.h>

#include <array>
#include <cstdint>
#include <stdexcept>

#include "render/loaded_context.h"

#if defined(__SANITIZE_ADDRESS__)
// OSMesa keeps its framebuffer records, about a kilobyte, until the process ends.
extern "C" const char* __lsan_default_suppressions() { return "leak:libOSMesa"; }
#endif

namespace seaway::render {
namespace {

class OsmesaContext final : public LoadedContext {
 public:
  OsmesaContext() : LoadedContext(&OSMesaGetProcAddress) {
    const int attributes[] = {OSMESA_FORMAT,
                              OSMESA_RGBA,
                              OSMESA_PROFILE,
                              OSMESA_CORE_PROFILE,
                              OSMESA_CONTEXT_MAJOR_VERSION,
                              4,
                              OSMESA_CONTEXT_MINOR_VERSION,
                              5,
                              0};
    context_ = OSMesaCreateContextAttribs(attributes, nullptr);
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
    if (!OSMesaMakeCurrent(context_, unused_.data(), GL_UNSIGNED_BYTE, side, side)) {
      throw std::runtime_error("OSMesa context cannot be made current");
    }
  }
  void unbind() noexcept override { OSMesaMakeCurrent(nullptr, nullptr, 0, 0, 0); }
  void destroy() {
    release();
    OSMesaDestroyContext(context_);
  }

  static constexpr int side = 4;
  OSMesaContext context_ = nullptr;
  // OSMesa insists on a default framebuffer; all drawing goes into framebuffers of our own.
  std::array<std::uint8_t, 4 * side * side> unused_{};
};

}  // namespace

std::unique_ptr<HeadlessContext> makeOsmesaContext() { return std::make_unique<OsmesaContext>(); }

}  // namespace seaway::render
