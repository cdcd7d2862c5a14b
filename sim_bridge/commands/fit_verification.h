#pragma once

#include <string>
#include <vector>

#include "surface/fit/octave_fit.h"
#include "surface/spectra/buoy_analysis.h"

namespace seaway::bridge {

/// A quantity that was asked of a sea and what a buoy in it read.
struct ReadBack {
  std::string name, unit;
  double asked = 0.0;
  double read = 0.0;
  double standardError = 0.0;  ///< that a record of this length brings, a Gaussian sea
  /// |read − asked| in standard errors.
  double deviations() const;
};

/// A buoy moored in a fitted field.
struct BuoyVerification {
  double hours = 0.0;
  BuoyAnalysis analysis;
  std::vector<ReadBack> quantities;  ///< H_m0, T_m02 and, where asked, direction and spread
  bool agrees = false;               ///< all within three standard errors
};

/// Moors a heave–slope buoy at the origin of the fitted field for `hours` h and reads H_m0 and
/// T_m02 over the target's band and, where the target has directions, mean direction (compass,
/// from) and spread about its peak. Standard errors: of H_m0 ½ H_m0 √(∫S² df/T)/m₀, of T_m02 by the
/// same propagation, of direction √((1 − r₂)/ν)/r₁ and spread √((1 + r₂ − 2r₁²)/ν)/spread (Kuik et
/// al. 1988) with ν = 2BT over a band of width B.
BuoyVerification verifyWithBuoy(const DirectionalSpectrum& target, const OctaveFit& fit,
                                double depth, std::uint64_t seed, double hours);

}  // namespace seaway::bridge
