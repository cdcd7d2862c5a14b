#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <limits>
#include <vector>

#include "surface/field/octave.h"
#include "surface/spectra/frequency_spectrum.h"

namespace seaway {

struct NewWaveOptions {
  double crestHeight = 1.0;     ///< m, > 0: the largest crest, at focus
  glm::dvec2 place{0.0};        ///< where it stands, m in the sea plane
  double time = 0.0;            ///< when, s
  double toward = 0.0;          ///< where the waves go, rad counter-clockwise from east
  std::size_t components = 64;  ///< regular waves, ≥ 2
  double depth = std::numeric_limits<double>::infinity();  ///< m, > 0
};

/// A focused wave group: the most probable shape of a sea of this spectrum around a crest of a
/// given height, as regular waves in phase at the focus (NewWave; Tromans, Anaturk & Hagemeijer
/// 1991). η = A/m₀ Σ Sₙ Δf cos(kₙ·(x − x₀) − ωₙ(t − t₀)).
///
/// The group comes back after 1/Δf s, Δf = band / components. Throws InputError for a spectrum
/// without energy and options out of range.
std::vector<Octave> newWave(const FrequencySpectrum& spectrum, const NewWaveOptions& options);

}  // namespace seaway
