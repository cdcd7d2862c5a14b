#pragma once

#include <glm/mat3x3.hpp>

#include "surface/hull/hull_file.h"

namespace seaway {

/// Body frame in metres from a mesh file's frame: its rows are the body's axes in the file's times
/// metres per unit. Throws InputError for settings out of range.
glm::dmat3 bodyFromFile(const HullFileSettings& settings);

}  // namespace seaway
