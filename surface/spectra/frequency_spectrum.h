#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace seaway {

/// Variance density of the surface elevation over frequency, piecewise linear between its bins.
///
/// Valid when both vectors have the same size ≥ 2, frequencies are finite, > 0 and rising, and
/// densities are finite and ≥ 0; `validate` says otherwise. Outside the band the density is 0.
struct FrequencySpectrum {
  std::vector<double> frequency;  ///< Hz
  std::vector<double> density;    ///< m²/Hz

  /// What is wrong with it, or nothing.
  std::optional<std::string> validate() const;

  double lowest() const { return frequency.front(); }  ///< Hz
  double highest() const { return frequency.back(); }  ///< Hz

  /// Density at a frequency in Hz, m²/Hz.
  double at(double frequency_hz) const;

  /// m_n = ∫ fⁿ S(f) df over the band, m²·Hzⁿ; trapezoidal rule on the bins.
  double moment(int n) const;

  double significantWaveHeight() const;  ///< H_m0 = 4√m₀, m
  double meanPeriodM01() const;          ///< T_m01 = m₀/m₁, s
  double zeroCrossingPeriod() const;     ///< T_m02 = √(m₀/m₂), s
  double energyPeriod() const;           ///< T_e = m₋₁/m₀, s

  /// T_p = 1/f at the largest density, s: the vertex of the parabola through the largest bin and
  /// its neighbours. 0 where there is no energy.
  double peakPeriod() const;
};

}  // namespace seaway
