#pragma once

#include <glm/mat2x2.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "surface/field/wave_field.h"

namespace seaway::render {

/// A square patch of ripples that tiles, for shading only: (slope x, slope y, |slope|²) a texel,
/// row by row, scaled to a mean-square slope of 1. Its filtered second moments tell what a mip
/// level has lost (LEAN mapping, Olano & Baker 2010). Always the same patch.
std::vector<glm::vec3> rippleTexture(int side);

/// How the two layers of ripples lie on the sea.
///
/// They stand for waves shorter than the field's shortest and move about as those do. Slopes only:
/// heights come from the field alone.
struct Ripples {
  double layerSlope = 0.0;  ///< mean-square slope of each layer
  double hairSlope = 0.0;   ///< mean-square slope of what is finer still
  glm::dmat2 textureFromWorld[2]{};
  glm::dvec2 drift[2]{};  ///< m/s

  /// Texture coordinate, in [0, 1), of a point of the sea plane at a time.
  glm::dvec2 textureCoordinate(int layer, glm::dvec2 point, double time) const;
};

/// Ripples that bring the field's mean-square slope up to Cox & Munk's total for the wind; none
/// where the field has as much already. `windSpeed` m/s at 12.5 m.
Ripples ripplesFor(const WaveField& waves, double windSpeed);

}  // namespace seaway::render
