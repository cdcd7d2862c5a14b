#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <string>

namespace seaway::bridge {

/// "640x480" as pixels. Throws InputError for anything else, and outside [1, 8192].
glm::ivec2 parseSize(const std::string& text);

/// A time given with `--time`: finite, ≥ 0. Throws InputError.
double requireTime(double time);

}  // namespace seaway::bridge
