#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "surface/field/wave_field.h"

namespace seaway::render {

/// Cox & Munk 1954 (doi:10.1364/JOSA.44.000838): mean-square slope of a clean sea at a wind of
/// `windSpeed` m/s at 12.5 m, both axes together.
double coxMunkMeanSquareSlope(double windSpeed);

/// Which waves a grid of a given spacing can carry, and how much slope it has to leave to shading.
///
/// An octave fades out as its dominant wavelength falls from 4 to 2 spacings. All octaves within
/// that range fade together, by one weight.
class BandLimit {
 public:
  explicit BandLimit(const WaveField& waves);

  struct Plan {
    double spacing = 0.0;           ///< m between vertices
    double keptWavelength = 0.0;    ///< octaves no shorter than this, m, are carried in full
    double fadingWavelength = 0.0;  ///< those between this, m, and it are carried times `weight`
    double weight = 0.0;            ///< [0, 1]
    double missingSlope = 0.0;      ///< mean-square slope that the grid does not carry, ≥ 0
  };
  /// `spacing` m between vertices, > 0.
  Plan planFor(double spacing) const;

  /// Mean-square slope of the whole field.
  double totalSlope() const { return totalSlope_; }
  /// Which way the waves' slopes lean, all together: (⟨sx² − sy²⟩, 2⟨sx sy⟩)/⟨sx² + sy²⟩ of slopes
  /// (sx, sy); of length 0 for even ones or none, 1 for waves of one direction.
  glm::dvec2 lean() const { return lean_; }

 private:
  struct Entry {
    double wavelength;  // dominant, m
    double slope;       // mean square
  };
  std::vector<Entry> octaves_;
  double totalSlope_ = 0.0;
  glm::dvec2 lean_{0.0};
};

}  // namespace seaway::render
