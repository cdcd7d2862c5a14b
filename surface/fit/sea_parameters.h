#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "surface/spectra/directional_spectrum.h"

namespace seaway {

/// A parameter with one standard deviation, from the covariance of its fit; NaN where there is
/// none.
struct Estimate {
  double value = std::numeric_limits<double>::quiet_NaN();
  double deviation = std::numeric_limits<double>::quiet_NaN();
};

/// A JONSWAP sea with cos²ˢ(θ/2) spreading.
struct WaveSystem {
  Estimate significantWaveHeight;  ///< H_m0, m
  Estimate peakPeriod;             ///< T_p, s
  Estimate peakEnhancement;        ///< γ, [1, 20]
  Estimate toward;                 ///< mean direction, rad counter-clockwise from east
  Estimate spreadExponent;         ///< s of cos²ˢ(θ/2), [0.1, 200]
};

struct SeaParameterOptions {
  /// Degrees of freedom of each spectral estimate, ≥ 2.
  double degreesOfFreedom = 20.0;
  /// 1 or 2, or 0: one or two, whichever has the lower AIC.
  int systems = 0;
  int maxIterations = 100;  ///< ≥ 1
};

struct SeaParameters {
  bool usable = false;
  std::string message;
  std::vector<WaveSystem> systems;  ///< from long waves to short: swell, wind sea
  std::size_t bins = 0;             ///< that entered the fit
  std::size_t zeroBins = 0;         ///< read zero, below the instrument's resolution: left out
  double deviance = 0.0;  ///< −2 ln of the likelihood's ratio to that of a perfect model
  double aic = 0.0;       ///< deviance + 2 parameters
  double aicOfOne = std::numeric_limits<double>::quiet_NaN();  ///< where both were tried
  double aicOfTwo = std::numeric_limits<double>::quiet_NaN();
  int iterations = 0;
  FrequencySpectrum model;  ///< on the target's frequencies
};

/// Fits a sea's parameters by maximum likelihood: spectral estimates scatter about the truth M as
/// M χ²_ν/ν, so the residuals are the gamma deviance's, sign(S − M) √(ν (S/M − ln(S/M) − 1)), and
/// one-sigma uncertainties follow from Ceres' covariance. Log residuals would bias H_m0 by −3 % at
/// ν = 16. Systems are JONSWAP seas (Hasselmann et al. 1973); directions follow from a₁, b₁ where
/// known, each bin weighted by its share of its system's peak, with the moments' sampling errors
/// (1 + r₂ − 2r₁²)/ν along and (1 − r₂)/ν across the mean direction (Kuik et al. 1988).
///
/// Bins that read zero are left out and counted. Fewer than 4 bins with energy for one system, or 7
/// for two: not usable, with a message. Throws InputError for options out of range. Thread-safe.
SeaParameters fitSeaParameters(const DirectionalSpectrum& target,
                               const SeaParameterOptions& options = {});

}  // namespace seaway
