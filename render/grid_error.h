#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "render/grid_layout.h"
#include "surface/field/wave_field.h"

namespace seaway::render {

/// How far the heights of a grid's drawn surface are off the waves, foreseen from where its
/// vertices lie: by what rows leave out (BandLimit), and by drawing straight between vertices.
/// Wakes and other disturbances are not in it.
class GridError {
 public:
  /// `layout`, which has no rings, must outlive this object.
  GridError(const WaveField& waves, const GridLayout& layout);
  GridError(const WaveField& waves, GridLayout&& layout) = delete;

  /// One standard deviation, m, at a place of the grid relative to the camera's foot point, m.
  double standardDeviationAt(glm::dvec2 place) const;

 private:
  struct Wave {
    double variance;           // m²
    double wavelength;         // dominant, m
    glm::dvec2 waveNumber{0};  // rad/m
  };
  std::vector<Wave> waves_;
  const GridLayout& layout_;
};

}  // namespace seaway::render
