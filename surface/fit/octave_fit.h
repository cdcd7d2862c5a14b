#pragma once

#include <limits>
#include <string>
#include <vector>

#include "surface/field/octave.h"
#include "surface/spectra/frequency_spectrum.h"

namespace seaway {

struct OctaveFitOptions {
  /// Octaves to fit, [1, 32].
  int octaves = 8;
  /// Ratio of neighbouring lattice sizes, λᵢ₊₁ = λᵢ/lacunarity, > 1. The largest that is used:
  /// where so many octaves would pass the end of the target's band they stand closer.
  double lacunarity = 2.0;
  /// Where the waves go, rad counter-clockwise from east.
  double toward = 0.0;
  /// m, > 0 or infinite: enters the dispersion that maps S(f) to S(k).
  double depth = std::numeric_limits<double>::infinity();
  /// Weight of ln(model/target) against the relative error in the sum of squares, ≥ 0: holds the
  /// tail, which carries the slopes, where the squared error alone is blind to it.
  double tailWeight = 0.02;
  /// Solver iterations for each trial of the first lattice size, ≥ 1.
  int maxIterations = 100;
  /// Trials of the first lattice size, ≥ 1; the best is kept.
  int latticeTrials = 9;
};

struct OctaveFitSummary {
  /// The octaves stand for the target; if false, `message` says why not and they must not be used.
  bool usable = false;
  std::string message;
  int iterations = 0;  ///< of the trial that was kept
  /// √(∫(M − S)² dk / ∫S² dk) between model and target over the target's band.
  double residualL2 = std::numeric_limits<double>::infinity();
  double hm0Target = 0.0, hm0Fit = 0.0;    ///< m; the fit's is of the whole field
  double tm02Target = 0.0, tm02Fit = 0.0;  ///< s, over the target's band
  double tpTarget = 0.0, tpFit = 0.0;      ///< s, largest density in frequency
};

struct OctaveFit {
  std::vector<Octave> octaves;  ///< in order of falling lattice size; empty unless usable
  OctaveFitSummary summary;
  FrequencySpectrum model;      ///< the fit mapped back to frequency, on 600 points of the band
};

/// Fits the standard deviations of Perlin octaves to a target frequency spectrum.
///
/// The kind has no dispersion, so the fit is made and judged on the omnidirectional wave-number
/// spectrum S(k) = S(f) df/dk. Unknowns are ln aᵢ² (no active bounds), solved by Ceres from band
/// integrals; then the whole field is scaled to the target's H_m0. Relative L2 residuals are near
/// 0.13 for Pierson–Moskowitz and 0.36 for JONSWAP γ = 3.3: the octaves' own width is the limit.
///
/// Throws InputError for options out of range. A target without energy, or not valid, gives a
/// summary that is not usable. Thread-safe.
OctaveFit fitPerlinOctaves(const FrequencySpectrum& target, const OctaveFitOptions& options = {});

}  // namespace seaway
