#pragma once

#include <vector>

#include "surface/field/wave_field.h"
#include "surface/spectra/families.h"

/// Other ways to make a sea, as good as we can write them, to set beside the wave field.
namespace seaway::rivals {

/// Octaves fitted to a sea, and √(∫(M − S)²/∫S²) of the fit.
struct FittedOctaves {
  std::vector<Octave> octaves;
  double residual = 0.0;
};
FittedOctaves groupOctaves(const FrequencySpectrum& target, int count);
FittedOctaves perlinOctaves(const FrequencySpectrum& target, int count);  ///< residual of S(k)

/// Eight Perlin octaves whose lattices halve, for CachedOctaves: the same sea continued to
/// 20 f_p, so that the shortest lattice still lies in its band.
FittedOctaves halvingPerlinOctaves(const JonswapParameters& sea);

/// `count` regular waves: SineSum's components as octaves.
std::vector<Octave> regularWaves(const FrequencySpectrum& target, int count);

/// Residual of `count` sine components, each one's variance spread evenly over its band.
double sineResidual(const FrequencySpectrum& target, std::size_t count);

/// Residual of variances in equal bands of the target's range.
double bandResidual(const FrequencySpectrum& target, const std::vector<double>& variance);

}  // namespace seaway::rivals
