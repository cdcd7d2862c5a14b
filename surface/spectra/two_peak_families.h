#pragma once

#include <cstddef>

#include "surface/spectra/frequency_spectrum.h"

namespace seaway {

/// One of the two systems of an Ochi–Hubble sea.
struct OchiHubblePart {
  double significantWaveHeight = 1.0;  ///< H, m, ≥ 0
  double peakPeriod = 10.0;            ///< s, > 0
  double shape = 1.0;  ///< λ, (0, 20]; 1 is Pierson–Moskowitz, larger is narrower
};

/// Density of one system, m²/Hz: with B = (4λ + 1)/4 ω_p⁴,
/// S(ω) = ¼ B^λ / Γ(λ) · H² ω^−(4λ+1) exp(−B/ω⁴), S(f) = 2π S(ω). Its m₀ is H²/16 and its peak lies
/// at ω_p, exactly. (Ochi & Hubble 1976, eq. 4)
double ochiHubbleDensity(double frequency, const OchiHubblePart& part);

/// Six-parameter spectrum: the sum of two systems on `count` frequencies, even in ln f, from 0.3 of
/// the lower peak to 8 of the higher, scaled there to H_m0 = √(H₁² + H₂²). Throws InputError for a
/// parameter out of range, or where both heights are 0.
FrequencySpectrum ochiHubble(const OchiHubblePart& swell, const OchiHubblePart& windSea,
                             std::size_t count = 600);

/// The most probable of the family for an H_m0 in (0, 20] m, North Atlantic: H₁ = 0.84 H,
/// H₂ = 0.54 H, ω₁ = 0.70 e^(−0.046 H), ω₂ = 1.15 e^(−0.039 H), λ₁ = 3, λ₂ = 1.54 e^(−0.062 H), H
/// in m (Ochi & Hubble 1976, table of most probable parameters). Their heights make 0.9986 H
/// together; scaled to H.
FrequencySpectrum ochiHubbleMostProbable(double significantWaveHeight, std::size_t count = 600);

/// What the simplified Torsethaugen model makes of (H_m0, T_p).
struct TorsethaugenSystems {
  bool windDominated = true;     ///< T_p ≤ T_f = 6.6 H_m0^⅓: the primary system is the wind sea
  double primaryHeight = 0.0;    ///< m
  double primaryPeriod = 0.0;    ///< s
  double peakEnhancement = 1.0;  ///< γ of the primary system, ≥ 1
  double secondaryHeight = 0.0;  ///< m; 0 where T_p = T_f
  double secondaryPeriod = 0.0;  ///< s
};

/// Divides a sea into its two systems: Torsethaugen & Haver 2004 (ISOPE 2004-JSC-193), table 1, the
/// simplified form of DNV-RP-C205 appendix A; a_f = 6.6 (fetch 370 km). Throws InputError for
/// a parameter out of range.
TorsethaugenSystems torsethaugenSystems(double significantWaveHeight, double peakPeriod);

/// Simplified Torsethaugen density, m²/Hz, before scaling: E_j S_nj(f T_pj), E = H² T_p/16,
/// S_n = 3.26 A_γ f_n⁻⁴ exp(−f_n⁻⁴) γ^exp(−(f_n − 1)²/(2σ²)), A_γ = (1 + 1.1 (ln γ)^1.19)/γ.
/// H_m0 comes out within 3 % of the one asked (A_γ is an approximation).
double torsethaugenDensity(double frequency, const TorsethaugenSystems& systems);

/// That spectrum on `count` frequencies as for `ochiHubble`, scaled there to the H_m0 asked for.
FrequencySpectrum torsethaugen(double significantWaveHeight, double peakPeriod,
                               std::size_t count = 600);

}  // namespace seaway
