#pragma once

namespace seaway {

/// Angle θ, rad in [−π, π], below which the part `quantile` of the spreading function
/// D(θ) ∝ cos²ˢ(θ/2) lies.
///
/// `exponent` s ≥ 0.5; infinite gives 0. `quantile` in (0, 1). Bisection on a trapezoidal integral;
/// error below 1e-3 rad (tests/surface/spectra/directional_spread_test.cpp).
double spreadQuantile(double exponent, double quantile);

/// The n-th number, n ≥ 0, of the van der Corput sequence in base 2, within (0, 1): quantiles that
/// any prefix of octaves spreads evenly.
double vanDerCorput(unsigned n);

}  // namespace seaway
