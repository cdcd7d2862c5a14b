// This file does not include glad, so that EGL's headers and its own do not meet.
#include "render/egl_context.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <sstream>
#include <stdexcept>
#include <string_view>

#include "render/loaded_context.h"

namespace seaway::render {
namespace {

std::string withError(const std::string& what) {
  std::ostringstream text;
  text << what << " (EGL error 0x" << std::hex << eglGetError() << ')';
  return text.str();
}

bool hasWord(const char* words, std::string_view word) {
  std::istringstream list(words ? words : "");
  for (std::string each; list >> each;) {
    if (each == word) return true;
  }
  return false;
}

bool clientOffers(std::string_view extension) {
  return hasWord(eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS), extension);
}

std::vector<EGLDeviceEXT> devices() {
  const bool listed =
      clientOffers("EGL_EXT_device_enumeration") || clientOffers("EGL_EXT_device_base");
  const auto query = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(
      listed ? eglGetProcAddress("eglQueryDevicesEXT") : nullptr);
  EGLint count = 0;
  if (!query || !query(0, nullptr, &count)) return {};
  std::vector<EGLDeviceEXT> result(static_cast<std::size_t>(count));
  if (!query(count, result.data(), &count)) return {};
  result.resize(static_cast<std::size_t>(count));
  return result;
}

/// The display of a platform, initialised; throws where there is none.
EGLDisplay openDisplay(EGLenum platform, void* native, const std::string& name) {
  const EGLDisplay display = eglGetPlatformDisplay(platform, native, nullptr);
  if (display == EGL_NO_DISPLAY) throw std::runtime_error(withError(name + " has no display"));
  if (!eglInitialize(display, nullptr, nullptr)) {
    throw std::runtime_error(withError(name + " does not start"));
  }
  return display;
}

EGLConfig chooseConfig(EGLDisplay display) {
  if (hasWord(eglQueryString(display, EGL_EXTENSIONS), "EGL_KHR_no_config_context")) {
    return EGL_NO_CONFIG_KHR;
  }
  const EGLint wanted[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, EGL_DONT_CARE,
                           EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (!eglChooseConfig(display, wanted, &config, 1, &count) || count == 0) {
    throw std::runtime_error(withError("EGL has no configuration for OpenGL"));
  }
  return config;
}

class EglContext final : public LoadedContext {
 public:
  EglContext(EGLDisplay display, std::string backend)
      : LoadedContext(&eglGetProcAddress), display_(display), backend_(std::move(backend)) {
    eglBindAPI(EGL_OPENGL_API);
    const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                 4,
                                 EGL_CONTEXT_MINOR_VERSION,
                                 5,
                                 EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                 EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                 EGL_NONE};
    context_ = eglCreateContext(display_, chooseConfig(display_), EGL_NO_CONTEXT, attributes);
    if (context_ == EGL_NO_CONTEXT) {
      throw std::runtime_error(withError("EGL offers no OpenGL 4.5 core context"));
    }
    try {
      load();
    } catch (...) {
      destroy();
      throw;
    }
  }
  ~EglContext() override { destroy(); }
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

  std::string backend() const override { return backend_; }

 private:
  void bind() override {
    eglBindAPI(EGL_OPENGL_API);
    if (!eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_)) {
      throw std::runtime_error(withError("EGL context cannot be made current without a surface"));
    }
  }
  void unbind() noexcept override {
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  }
  void destroy() {
    release();
    eglDestroyContext(display_, context_);
  }

  EGLDisplay display_;
  EGLContext context_ = EGL_NO_CONTEXT;
  std::string backend_;
};

std::unique_ptr<HeadlessContext> onDevice(EGLDeviceEXT device, const std::string& backend) {
  return std::make_unique<EglContext>(
      openDisplay(EGL_PLATFORM_DEVICE_EXT, device, "this EGL device"), backend);
}

}  // namespace

int eglDeviceCount() { return static_cast<int>(devices().size()); }

bool eglIsHeadless() {
  return clientOffers("EGL_MESA_platform_surfaceless") || eglDeviceCount() > 0;
}

std::unique_ptr<HeadlessContext> makeEglContext(int device, const std::string& backend) {
  const std::vector<EGLDeviceEXT> all = devices();
  if (device >= 0) return onDevice(all.at(static_cast<std::size_t>(device)), backend);
  std::string reasons;
  const auto attempt = [&](auto make) -> std::unique_ptr<HeadlessContext> {
    try {
      return make();
    } catch (const std::runtime_error& error) {
      reasons += std::string(reasons.empty() ? "" : "; ") + error.what();
      return nullptr;
    }
  };
  if (clientOffers("EGL_MESA_platform_surfaceless")) {
    auto made = attempt([&] {
      return std::make_unique<EglContext>(
          openDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, "EGL without a surface"),
          backend);
    });
    if (made) return made;
  }
  for (const EGLDeviceEXT each : all) {
    if (auto made = attempt([&] { return onDevice(each, backend); })) return made;
  }
  throw std::runtime_error(reasons.empty() ? "EGL has no device and no surfaceless platform"
                                           : reasons);
}

}  // namespace seaway::render
