#pragma once

#include <cstddef>
#include <vector>

#include "surface/spectra/directional_spectrum.h"

/// Distributions D(θ) of a frequency's energy over direction, ∫D dθ = 1, and frequency spectra
/// spread by them over a grid of directions. Angles in rad, counter-clockwise.
namespace seaway {

/// cos²ˢ spreading: D(θ) = 2^(2s−1) Γ²(s + 1)/(π Γ(2s + 1)) cos²ˢ(θ/2), per rad, θ from the mean
/// direction. s ≥ 0. Its first moment is r₁ = s/(s + 1). (Longuet-Higgins, Cartwright & Smith 1963)
double cosinePowerSpreading(double angle, double s);

/// Normal distribution with standard deviation `sigma` rad > 0, wrapped around the circle: per rad;
/// its moments are r_n = exp(−n² σ²/2). (Mardia & Jupp 2000, §3.5.7)
double wrappedNormalSpreading(double angle, double sigma);

/// Exponent s at a frequency by Mitsuyasu et al. 1975: s_p (f/f_p)⁵ up to the peak, s_p
/// (f/f_p)^−2.5 above.
double mitsuyasuExponent(double frequency, double peakFrequency, double peakExponent);

/// Mitsuyasu's exponent at the peak, s_p = 11.5 (2π f_p U/g)^−2.5, of a wind of U m/s at 10 m.
double mitsuyasuPeakExponent(double peakFrequency, double windSpeed);

/// `count` directions evenly over a whole turn from 0, rad toward.
std::vector<double> evenDirections(std::size_t count);

/// The spectra below have `directions` even directions and S(f) = Σ E(f, θ) Δθ to rounding. D is
/// taken at the grid's directions and normalised there: the mean direction and r₁ are those of the
/// continuous D within 1e-3 where its standard deviation is at least the grid's spacing; narrower,
/// the energy falls on the nearest directions. They throw InputError for an invalid spectrum, fewer
/// than 3 directions or more than 3600, or a parameter out of range.

/// Spread by cos²ˢ, s in [0, 1e6], about `toward`.
DirectionalSpectrum spreadByCosinePower(const FrequencySpectrum& energy, double toward, double s,
                                        std::size_t directions = 72);

/// Spread by cos²ˢ with Mitsuyasu's exponent, `peakExponent` in (0, 1e6], about `toward`.
DirectionalSpectrum spreadByMitsuyasu(const FrequencySpectrum& energy, double toward,
                                      double peakFrequency, double peakExponent,
                                      std::size_t directions = 72);

/// Spread by a wrapped normal distribution, `sigma` in (0, π] rad, about `toward`.
DirectionalSpectrum spreadByWrappedNormal(const FrequencySpectrum& energy, double toward,
                                          double sigma, std::size_t directions = 72);

/// All energy toward one direction: moments only (r = 1), no grid. Throws for an invalid spectrum.
DirectionalSpectrum unidirectional(const FrequencySpectrum& energy, double toward);

}  // namespace seaway
