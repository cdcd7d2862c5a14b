#pragma once

#include <string_view>

namespace seaway::render {

/// Text of a file of render/shaders/, embedded at build time; empty for an unknown name.
std::string_view shaderSource(std::string_view name);

}  // namespace seaway::render
