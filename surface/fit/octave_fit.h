#pragma once

#include <limits>
#include <string>
#include <vector>

#include "surface/field/octave.h"
#include "surface/spectra/frequency_spectrum.h"

namespace seaway {

struct OctaveFitOptions {
  /// Octaves to fit, [1, 64].
  int octaves = 8;
  /// Perlin octaves: ratio of neighbouring lattice sizes, λᵢ₊₁ = λᵢ/lacunarity, > 1. The largest that is used:
  /// where so many octaves would pass the end of the target's band they stand closer.
  double lacunarity = 2.0;
  /// Where the waves go, rad counter-clockwise from east.
  double toward = 0.0;
  /// Group octaves: full width at half maximum of each octave over direction, rad, (0, π].
  double directionalWidth = 0.35;
  /// m, > 0 or infinite: enters the dispersion that maps S(f) to S(k).
  double depth = std::numeric_limits<double>::infinity();
  /// Weight of ln(model/target) against the relative error in the sum of squares, ≥ 0: holds the
  /// tail, which carries the slopes, where the squared error alone is blind to it.
  double tailWeight = 0.02;
  /// Solver iterations for each trial, ≥ 1.
  int maxIterations = 100;
  /// Perlin octaves: trials of the first lattice size, ≥ 1; the best is kept.
  int latticeTrials = 9;
};

struct OctaveFitSummary {
  /// The octaves stand for the target; if false, `message` says why not and they must not be used.
  bool usable = false;
  std::string message;
  int iterations = 0;  ///< of the trial that was kept
  /// √(∫(M − S)² / ∫S²) between model and target over the target's band: in wave number for
  /// Perlin octaves, in frequency for group octaves.
  double residualL2 = std::numeric_limits<double>::infinity();
  double hm0Target = 0.0, hm0Fit = 0.0;    ///< m; the fit's is of the whole field
  double tm02Target = 0.0, tm02Fit = 0.0;  ///< s, over the target's band
  double tpTarget = 0.0, tpFit = 0.0;      ///< s, largest density in frequency
};

struct OctaveFit {
  std::vector<Octave> octaves;  ///< from long waves to short; empty unless usable
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

/// Fits the standard deviations of group octaves to a target frequency spectrum, on S(f) itself:
/// the spectrum a buoy at a fixed point sees. Centres stand at quantiles of a power of the target
/// and widths follow the room between them; the best of nine such choices is kept. Relative L2
/// residuals for JONSWAP are 0.05–0.11 with 12 octaves and below 0.025 with 24. All else as above.
OctaveFit fitGroupOctaves(const FrequencySpectrum& target, const OctaveFitOptions& options = {});

}  // namespace seaway
