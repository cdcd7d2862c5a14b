#pragma once

namespace seaway {

/// Spectrum of Perlin octaves: what each lattice contributes at which wave number.
///
/// At a fixed time the noise is Σ_c g_c·d_c w(d_c) over lattice corners with independent
/// gradients in the plane; averaged over the phase of the lattice its power spectrum is the sum
/// over gradient components of |Fourier transform of d·w|². Averaged over direction that gives a
/// density in wave number, computed here by quadrature (tests/surface/perlin_spectrum_test.cpp
/// compares it with a periodogram of the octave itself).

/// Wave number at which an octave's omnidirectional spectrum is largest, in cycles per lattice
/// cell. The test finds it again from `perlinWaveNumberDensity`.
inline constexpr double perlinPeakCyclesPerCell = 0.59;

/// Share of an octave's variance per unit of q, where q is the wave number in cycles per lattice
/// cell, q ≥ 0. Integrates to 1; accurate to 1e-4 of its maximum. Beyond q = 4, where less than
/// 1e-4 of the variance lies, it is 0. Thread-safe.
double perlinWaveNumberDensity(double q);

}  // namespace seaway
