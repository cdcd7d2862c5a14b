// This file does not include glad: osmesa.h brings GL/gl.h, and the two define the same names.
#include "render/osmesa_context.h"

#include <GL/osmesa.h>

#include <array>
#include <cstdint>
#include <stdexcept>

#include "render/gl/loader.h"

#if defined(__SANITIZE_ADDRESS__)
// OSMesa keeps its framebuffer records, about a kilobyte, until the process ends.
extern "C" const char* __lsan_default_suppressions() { return "leak:libOSMesa"; }
#endif

namespace seaway::render {
namespace {

class OsmesaContext final : public HeadlessContext {
 public:
  OsmesaContext() {
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
      makeCurrent();
      description_ = loadGl(&OSMesaGetProcAddress);
    } catch (...) {
      OSMesaDestroyContext(context_);
      throw;
    }
  }
  ~OsmesaContext() override {
    // A destroyed context that stays current could be taken for a new one at the same address.
    if (OSMesaGetCurrentContext() == context_) OSMesaMakeCurrent(nullptr, nullptr, 0, 0, 0);
    OSMesaDestroyContext(context_);
  }
  OsmesaContext(const OsmesaContext&) = delete;
  OsmesaContext& operator=(const OsmesaContext&) = delete;

  void makeCurrent() override {
    if (OSMesaGetCurrentContext() == context_) return;
    if (!OSMesaMakeCurrent(context_, unused_.data(), GL_UNSIGNED_BYTE, side, side)) {
      throw std::runtime_error("OSMesa context cannot be made current");
    }
  }

  std::string backend() const override { return "osmesa"; }
  std::string renderer() const override { return description_.renderer; }
  std::string version() const override { return description_.version; }
  int maximumSize() const override { return description_.maximumSize; }

 private:
  static constexpr int side = 4;
  OSMesaContext context_ = nullptr;
  // OSMesa insists on a default framebuffer; all drawing goes into framebuffers of our own.
  std::array<std::uint8_t, 4 * side * side> unused_{};
  GlDescription description_;
};

}  // namespace

std::unique_ptr<HeadlessContext> makeOsmesaContext() { return std::make_unique<OsmesaContext>(); }

}  // namespace seaway::render
