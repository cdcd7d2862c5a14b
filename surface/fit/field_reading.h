#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "surface/field/octave.h"
#include "surface/spectra/directional_spectrum.h"

namespace seaway {

/// What a field of group octaves shows at a fixed point, in closed form.
struct FieldReading {
  /// S(f) and, as a heave–slope buoy would compute them from its co- and quad-spectra, a₁ … b₂;
  /// with a grid E(f, θ) where directions were asked for. Moments are NaN where S = 0.
  DirectionalSpectrum spectrum;
  std::vector<double> waveNumber;  ///< √((C₂₂ + C₃₃)/C₁₁), rad/m, as BuoyAnalysis::waveNumber

  /// Root mean square, weighted by energy, of waveNumber over the dispersion relation's, less 1.
  double waveNumberDeviation = 0.0;
};

/// The readings of `octaves` at frequencies (Hz, rising) and, where `directions` > 0, on as many
/// evenly spaced directions from 0. Octaves of other kinds are left out. Exact for linear theory to
/// first order in bandwidth, as the octaves are; regular waves have no density. Thread-safe.
FieldReading readField(std::span<const Octave> octaves, const std::vector<double>& frequency,
                       std::size_t directions = 0,
                       double depth = std::numeric_limits<double>::infinity());

}  // namespace seaway
