#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "surface/field/octave.h"
#include "surface/spectra/directional_spectrum.h"
#include "surface/spectra/frequency_spectrum.h"

namespace seaway {

struct OctaveFitOptions {
  /// Octaves to fit, [1, 64].
  int octaves = 8;
  /// Perlin octaves: ratio of neighbouring lattice sizes, λᵢ₊₁ = λᵢ/lacunarity, > 1. The largest
  /// that is used: where so many octaves would pass the end of the target's band they stand closer.
  double lacunarity = 2.0;
  /// Where the waves go, rad counter-clockwise from east; of targets without directions.
  double toward = 0.0;
  /// Group octaves of targets without directions: full width at half maximum of each octave over
  /// direction, rad, (0, π].
  double directionalWidth = 0.35;
  /// m, > 0 or infinite: enters the dispersion that maps S(f) to S(k).
  double depth = std::numeric_limits<double>::infinity();
  /// Weight of ln(model/target) against the relative error in the sum of squares, ≥ 0: holds the
  /// tail, which carries the slopes, where the squared error alone is blind to it.
  double tailWeight = 0.02;
  /// Solver iterations for each solve, ≥ 1.
  int maxIterations = 100;
  /// Perlin octaves: trials of the first lattice size, ≥ 1; the best is kept.
  int latticeTrials = 33;

  /// Group octaves: whether centres and bandwidths move, or stand at quantiles of the target.
  bool freeShapes = true;
  /// Group octaves: weight of the wave number's mean square deviation from the dispersion relation,
  /// ≥ 0. Without it broad short octaves follow S(f) more closely, but leak waves to frequencies
  /// where their wave number is wrong, and slopes with it.
  double deviationWeight = 1.0;
  /// Group octaves: starts that are tried, ≥ 1, [1, 1000]; the first is the same for any seed, the
  /// best is kept.
  int starts = 1;
  std::uint64_t seed = 1;  ///< of the starts after the first, and of `startScatter`
  double startScatter =
      0.0;  ///< ln variances start off by up to ± this, ≥ 0: to try the fit itself
};

struct OctaveFitSummary {
  /// The octaves stand for the target; if false, `message` says why not and they must not be used.
  bool usable = false;
  std::string message;
  int iterations = 0;  ///< of the start that was kept
  double cost =
      std::numeric_limits<double>::infinity();  ///< half the sum of squares, of that start
  /// √(∫(M − S)² / ∫S²) between model and target over the target's band: in wave number for
  /// Perlin octaves, in frequency for group octaves.
  double residualL2 = std::numeric_limits<double>::infinity();
  double residualGrid = 0.0;  ///< likewise over frequency and direction; 0 where there is no grid
  double hm0Target = 0.0, hm0Fit = 0.0;    ///< m; the fit's is of the whole field
  double hm0Band = 0.0;                    ///< m; the fit's over the target's band
  double tm02Target = 0.0, tm02Fit = 0.0;  ///< s, over the target's band
  double tpTarget = 0.0, tpFit = 0.0;      ///< s, largest density in frequency
  /// Group octaves: FieldReading::waveNumberDeviation over the band.
  double waveNumberDeviation = 0.0;
  /// Directional fits: root mean square, weighted by energy, of the difference in mean direction
  /// and in spread √(2(1 − r₁)), rad, between what a buoy would read and the target.
  double directionError = 0.0, spreadError = 0.0;
};

struct OctaveFit {
  std::vector<Octave> octaves;  ///< from long waves to short; empty unless usable
  OctaveFitSummary summary;
  /// The fit as a buoy reads it, on 600 points of the band; without moments for Perlin octaves,
  /// with the target's directions where that has a grid.
  DirectionalSpectrum model;
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

/// Fits group octaves to a target frequency spectrum, on S(f) itself: the spectrum a buoy at a
/// fixed point sees. Unknowns are ln aᵢ² and, if `freeShapes`, centres and bandwidths, from
/// quantiles of the target; first variances alone, then all. All else as above.
OctaveFit fitGroupOctaves(const FrequencySpectrum& target, const OctaveFitOptions& options = {});

/// Fits group octaves to a target with directions, their own directions and crest lengths freed
/// too. A target with a grid is fitted on E(f, θ); one with moments on S, S a₁, S b₁ and, where
/// known, S a₂, S b₂, against what a heave–slope buoy would read. Several octaves may share a
/// frequency. A target without directions is fitted as above.
OctaveFit fitGroupOctaves(const DirectionalSpectrum& target, const OctaveFitOptions& options = {});

/// Fits many targets on all cores, the same bits for any number of them.
std::vector<OctaveFit> fitGroupOctaves(std::span<const DirectionalSpectrum> targets,
                                       const OctaveFitOptions& options = {});

}  // namespace seaway
