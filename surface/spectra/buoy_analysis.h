#pragma once

#include <cstddef>
#include <vector>

#include "surface/spectra/directional_spectrum.h"
#include "surface/spectra/frequency_spectrum.h"

namespace seaway {

/// What a heave–slope buoy writes down at a fixed place, at equal steps of time.
struct BuoyRecord {
  double timeStep = 0.5;           ///< s, > 0
  std::vector<double> heave;       ///< η, m
  std::vector<double> slopeEast;   ///< ∂η/∂x, x east (or any axis from which directions count)
  std::vector<double> slopeNorth;  ///< ∂η/∂y, y 90° counter-clockwise from it

  double duration() const { return timeStep * static_cast<double>(heave.size()); }  ///< s
};

struct BuoyAnalysisOptions {
  /// Length of a Welch segment, s; brought down to an even number of samples, at least 8, at most
  /// the record. Longer: finer frequencies (1/segment), fewer degrees of freedom.
  double segment = 256.0;
};

/// What a buoy's record says of the sea.
struct BuoyAnalysis {
  FrequencySpectrum spectrum;  ///< 1/segment … 1/(2 · time step), every 1/segment
  std::vector<DirectionalMoments> directions;  ///< of each bin; NaN where there is no energy
  /// √((C₂₂ + C₃₃)/C₁₁) of each bin, rad/m: the waves' own wave number where heave and slopes agree
  /// with linear theory (a buoy's check ratio is this over the dispersion relation's).
  std::vector<double> waveNumber;
  DirectionalMoments peak;     ///< of the bin with the largest density
  DirectionalMoments overall;  ///< of all bins, weighted by density

  double significantWaveHeight = 0.0;  ///< H_m0 = 4√m₀, m
  double peakPeriod = 0.0;             ///< T_p, s (FrequencySpectrum::peakPeriod); NaN: no energy
  double zeroCrossingPeriod = 0.0;     ///< T_m02 = √(m₀/m₂), s; NaN: no energy
  double skewness = 0.0;               ///< of heave, μ₃/σ³; NaN where σ = 0
  double kurtosis = 0.0;  ///< of heave, μ₄/σ⁴, 3 for a Gaussian sea; NaN where σ = 0

  double segment = 0.0;           ///< s, as used
  std::size_t segments = 0;       ///< averaged, half overlapping
  double degreesOfFreedom = 0.0;  ///< of a density: 2K/(1 + (K − 1)/(18K)), K segments
  /// One standard deviation of H_m0 that the record's finite length brings, m, Gaussian sea:
  /// ½ H_m0 √(∫S² df/T)/m₀. Holds where peaks are wider than 1/segment.
  double significantWaveHeightError = 0.0;
};

/// Welch's method (Hann window, 50 % overlap, each segment's mean removed; samples after the last
/// whole segment left out), with moments by rectangles over all bins of `spectrum`, so that m₀ is
/// the windowed segments' mean square, zero frequency aside.
///
/// Directions from the co- and quad-spectra of heave (1) and slopes (2, 3):
/// a₁ = Q₁₂/√(C₁₁(C₂₂ + C₃₃)), b₁ = Q₁₃/√(C₁₁(C₂₂ + C₃₃)), a₂ = (C₂₂ − C₃₃)/(C₂₂ + C₃₃),
/// b₂ = 2C₂₃/(C₂₂ + C₃₃) (Longuet-Higgins, Cartwright & Smith 1963), where C − iQ is the cross
/// spectrum X₁* X₂ of transforms with e^{−iωt}: slopes lag heave by a quarter period in the
/// direction in which a wave travels.
///
/// Throws InputError for series of different lengths, values that are not finite, a time step that
/// is not > 0, or a segment shorter than 8 samples or longer than the record. Thread-safe.
BuoyAnalysis analyseBuoy(const BuoyRecord& record, const BuoyAnalysisOptions& options = {});

}  // namespace seaway
