#pragma once

#include <glm/vec2.hpp>

#include "render/camera.h"

namespace seaway::render {

/// A point of the picture brought back to the sea.
struct SeaPoint {
  glm::dvec2 point{0.0};  ///< in the sea plane, m
  double height = 0.0;    ///< above the still-water level of the curved sea, m
};

/// What a pixel at `axialDepth` m (as in DepthImage) shows; (0, 0) is the top left pixel. Exact
/// but for the depth's own rounding, which a ray at grazing angle g turns into depth·2⁻²⁴·sin g of
/// height.
SeaPoint unproject(const Camera& camera, glm::dvec2 pixel, double axialDepth);

}  // namespace seaway::render
