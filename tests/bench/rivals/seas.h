#pragma once

#include <vector>

#include "surface/field/wave_field.h"
#include "surface/spectra/frequency_spectrum.h"

namespace seaway::bench {

/// The sea that every rival stands for: JONSWAP, H_m0 1.12 m, T_p 5.6 s, γ 3.3.
FrequencySpectrum targetSpectrum();

/// Octaves fitted to it, and √(∫(M − S)²/∫S²) of the fit.
struct FittedOctaves {
  std::vector<Octave> octaves;
  double residual = 0.0;
};
FittedOctaves groupOctaves(int count);
FittedOctaves perlinOctaves(int count);  ///< residual of S(k)

/// Eight Perlin octaves whose lattices halve, for CachedOctaves: the same sea continued to
/// 20 f_p, so that the shortest lattice still lies in its band.
FittedOctaves halvingPerlinOctaves();

/// `count` regular waves: SineSum's components as octaves.
std::vector<Octave> regularWaves(int count);

/// Residual of `count` sine components, each one's variance spread evenly over its band.
double sineResidual(std::size_t count);

/// Residual of variances in equal bands of the target's range.
double bandResidual(const std::vector<double>& variance);

}  // namespace seaway::bench
