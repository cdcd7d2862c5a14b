#pragma once

#include <memory>
#include <string>
#include <vector>

#include "render/headless_context.h"

namespace seaway::render {

/// A context of EGL without any surface. `device` −1: Mesa's surfaceless platform, else the first
/// device that offers OpenGL 4.5; ≥ 0: that device. Displays stay open until the process ends, for
/// the next context. Throws std::runtime_error if it does not start.
std::unique_ptr<HeadlessContext> makeEglContext(int device, const std::string& backend);

/// Number of EGL devices; 0 where EGL cannot list them.
int eglDeviceCount();

/// Whether EGL can draw without a window system at all.
bool eglIsHeadless();

}  // namespace seaway::render
