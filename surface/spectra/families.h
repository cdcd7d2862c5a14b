#pragma once

#include <cstddef>

#include "surface/spectra/frequency_spectrum.h"

namespace seaway {

/// Parameters of a JONSWAP sea.
struct JonswapParameters {
  double significantWaveHeight = 1.0;  ///< H_m0, m, > 0
  double peakPeriod = 6.0;             ///< T_p, s, > 0
  double peakEnhancement = 3.3;        ///< γ, [1, 20]; 1 is Pierson–Moskowitz
};

/// JONSWAP density at a frequency (Hz), not scaled to any wave height:
/// f⁻⁵ exp(−1.25 (f/f_p)⁻⁴) γ^exp(−(f/f_p − 1)²/(2σ²)), σ = 0.07 below the peak, 0.09 above.
/// (Hasselmann et al. 1973; DNV-RP-C205 §3.5.5)
double jonswapShape(double frequency, double peakFrequency, double peakEnhancement);

/// JONSWAP spectrum on `count` uniform frequencies over 0.3–8 f_p, scaled there so that its H_m0
/// is the one asked for. Throws InputError for a parameter out of range.
FrequencySpectrum jonswap(const JonswapParameters& parameters, std::size_t count = 600);

/// Pierson–Moskowitz spectrum by H_m0 (m) and T_p (s): JONSWAP with γ = 1.
FrequencySpectrum piersonMoskowitz(double significantWaveHeight, double peakPeriod,
                                   std::size_t count = 600);

}  // namespace seaway
