#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "surface/field/wave_field.h"

namespace seaway::render {

/// Mean-square slope (both axes together) of an octave, closed form from its spectrum:
/// a² (2π/λ)² ⟨q²⟩, q in cycles per lattice cell (tests/render/band_limit_test.cpp compares it
/// with sampled slopes).
double meanSquareSlope(const Octave& octave);

/// Cox & Munk 1954 (doi:10.1364/JOSA.44.000838): mean-square slope of a clean sea at a wind of
/// `windSpeed` m/s at 12.5 m, both axes together.
double coxMunkMeanSquareSlope(double windSpeed);

/// Which waves a grid of a given spacing can carry, and how much slope it has to leave to shading.
///
/// An octave fades out as its dominant wavelength falls from 4 to 2 spacings. Octaves come out of
/// `WaterSurface::sample` as a prefix (by falling variance), so what fades together is the group of
/// octaves between two prefixes.
class BandLimit {
 public:
  explicit BandLimit(const WaveField& waves);

  struct Plan {
    std::size_t kept = 0;       ///< octaves carried in full
    std::size_t fading = 0;     ///< octaves in [kept, fading) are carried times `weight`
    double weight = 0.0;        ///< [0, 1]
    double missingSlope = 0.0;  ///< mean-square slope that the grid does not carry, ≥ 0
  };
  /// `spacing` m between vertices, > 0.
  Plan planFor(double spacing) const;

  /// Mean-square slope of the whole field.
  double totalSlope() const { return totalSlope_; }

 private:
  struct Entry {
    double wavelength;  // dominant, m
    double variance;    // of height, m²
    double slope;       // mean square
  };
  std::vector<Entry> octaves_;
  double totalVariance_ = 0.0, totalSlope_ = 0.0;
};

}  // namespace seaway::render
