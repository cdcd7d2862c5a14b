#pragma once

#include <glm/vec2.hpp>

namespace seaway {

/// Value and derivatives of one octave at a point of the sea plane.
struct OctaveSample {
  double height = 0.0;            ///< m
  glm::dvec2 slope{0.0};          ///< (∂/∂x, ∂/∂y)
  double verticalVelocity = 0.0;  ///< ∂/∂t at the fixed point, m/s
};

}  // namespace seaway
