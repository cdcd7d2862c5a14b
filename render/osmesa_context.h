#pragma once

#include <memory>

#include "render/headless_context.h"

namespace seaway::render {

/// Mesa's off-screen context (software). Removed upstream in Mesa 25.1; Debian 12 has it.
/// Throws std::runtime_error if it does not start.
std::unique_ptr<HeadlessContext> makeOsmesaContext();

/// Whether its library is there; it is loaded when first asked for.
bool osmesaIsInstalled();

}  // namespace seaway::render
