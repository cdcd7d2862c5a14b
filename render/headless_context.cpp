#include "render/headless_context.h"

#include <charconv>
#include <stdexcept>

#include "render/egl_context.h"
#include "render/osmesa_context.h"
#include "surface/input_error.h"

namespace seaway::render {
namespace {

constexpr const char* forms = "must be osmesa, egl or egl:N with N the number of an EGL device";

struct BackendName {
  bool egl = false;
  int device = -1;  // −1: whichever EGL finds best
};

BackendName parse(const std::string& text) {
  if (text == "osmesa") return {};
  if (text == "egl") return {true, -1};
  if (text.rfind("egl:", 0) == 0) {
    BackendName name{true, -1};
    const char* end = text.data() + text.size();
    const auto number = std::from_chars(text.data() + 4, end, name.device);
    if (number.ec == std::errc{} && number.ptr == end && name.device >= 0) return name;
  }
  throw InputError("graphics backend '" + text + "' is not known; " + forms);
}

std::string offered() {
  std::string list;
  for (const std::string& name : headlessBackends()) list += (list.empty() ? "" : ", ") + name;
  return "this machine offers: " + list;
}

BackendName checked(const std::string& backend) {
  const BackendName name = parse(backend);
  if (name.egl && name.device >= eglDeviceCount()) {
    throw InputError("graphics backend '" + backend + "': there is no such EGL device; " +
                     offered());
  }
  return name;
}

}  // namespace

void requireBackend(const std::string& backend) { checked(backend); }

std::vector<std::string> headlessBackends() {
  std::vector<std::string> result;
  if (osmesaIsInstalled()) result.emplace_back("osmesa");
  if (eglIsHeadless()) result.emplace_back("egl");
  const int devices = eglDeviceCount();
  for (int device = 0; device < devices; ++device) {
    result.push_back("egl:" + std::to_string(device));
  }
  return result;
}

std::unique_ptr<HeadlessContext> makeHeadlessContext(const std::string& backend) {
  const BackendName name = checked(backend);
  try {
    return name.egl ? makeEglContext(name.device, backend) : makeOsmesaContext();
  } catch (const std::runtime_error& error) {
    throw std::runtime_error("graphics backend '" + backend + "': " + error.what() + "; " +
                             offered());
  }
}

}  // namespace seaway::render
