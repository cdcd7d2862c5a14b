#pragma once

namespace seaway {

/// Spectrum of a group octave's envelope along one lattice axis, |Fourier transform of the blending
/// kernel|², at q cycles per cell: even, integrates to 1 over −∞ … ∞. At a fixed point the octave's
/// spectrum is this, shifted to its frequency, with q = (f − fᵢ) ℓ∥/c_g.
///
/// Its full width at half maximum is `groupBandCycles`; beyond |q| = 4, where less than 1e-5 of the
/// variance lies, it is 0. Accurate to 1e-5 of its maximum; thread-safe.
double groupEnvelopeDensity(double q);

/// Its derivative, per cycle per cell.
double groupEnvelopeSlope(double q);

}  // namespace seaway
