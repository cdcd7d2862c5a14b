#pragma once

#include <cstddef>

#include "surface/spectra/frequency_spectrum.h"

/// Wind seas with one peak. Two peaks: two_peak_families.h; swell: swell.h; presets by the state of
/// the sea: sea_states.h; directions: spreading.h.
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

/// Pierson–Moskowitz spectrum by H_m0 (m) and T_p (s): JONSWAP with γ = 1 (ISSC, Bretschneider).
FrequencySpectrum piersonMoskowitz(double significantWaveHeight, double peakPeriod,
                                   std::size_t count = 600);

/// Fully developed sea of a wind of U m/s at 19.5 m: S(ω) = α g² ω⁻⁵ exp(−β (g/(Uω))⁴), α = 0.0081,
/// β = 0.74; so H_m0 = 2√(α/β) U²/g = 0.209 U²/g and ω_p = (4β/5)^¼ g/U = 0.877 g/U.
/// U in (0, 100]; else throws InputError. (Pierson & Moskowitz 1964)
FrequencySpectrum piersonMoskowitzOfWind(double windSpeed, std::size_t count = 600);

/// Kitaigorodskii's factor φ(ω_h), ω_h = ω√(d/g), for water of depth d (m; infinity: 1), by the
/// approximation of Thompson & Vincent 1983: ω_h²/2 for ω_h ≤ 1, 1 − (2 − ω_h)²/2 below 2, then 1.
/// Within 4 % of the exact factor.
double finiteDepthFactor(double frequency, double depth);

/// TMA spectrum: JONSWAP × φ, scaled over its band to the H_m0 asked for. In shallow water the
/// highest density lies above 1/T_p, since φ rises there. (Bouws et al. 1985; DNV-RP-C205 §3.5.6)
/// Throws InputError for a parameter out of range, depth in (0, ∞].
FrequencySpectrum tma(const JonswapParameters& parameters, double depth, std::size_t count = 600);

}  // namespace seaway
