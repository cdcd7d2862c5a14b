#pragma once

#include <string>

namespace seaway::bridge {

/// Shortest text that reads back as the same double; `nan`, `inf`, `-inf`.
std::string numberText(double value);
std::string numberText(float value);  ///< reads back as the same float

}  // namespace seaway::bridge
