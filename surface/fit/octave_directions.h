#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "surface/field/octave.h"

namespace seaway {

/// How many octaves to fit so that `spreadDirections` makes `count` of them: two thirds, rounded.
/// More would follow S(f) closer and leave fewer pairs.
constexpr int octavesBeforeSpreading(int count) { return (2 * count + 1) / 3; }

/// Full width at half maximum over direction (rad) that a group octave of a sea with spreading
/// D(θ) ∝ cos²ˢ(θ/2) should have of its own: 0.35, or the sea's whole spread where that is less,
/// but no less than 0.05, a cell of 14 wavelengths along the crest.
double directionalWidthFor(double exponent);

/// Gives group octaves of one frequency each directions that together have the mean direction and
/// the first moment r₁ = s/(s + 1) of D(θ) ∝ cos²ˢ(θ/2) about the octaves' own `toward`.
///
/// A buoy tells directions frequency by frequency, where it sees hardly more than one octave: so
/// the strongest `count` − n of the n octaves become pairs of half the variance at ±θ, whose mean
/// is exact at their frequency; the others stand alternately left and right, half as far. θ
/// alternates by 15 % about one value, found so that Σa² cos θ of the pairs, with their own widths,
/// gives r₁.
///
/// `octaves` from long waves to short; `exponent` s ≥ 0.5, infinite: nothing is done. Heights do
/// not change: Σa² stays, and so does S(f). A function of the octaves alone: every seed gets the
/// same directions. tests/surface/octave_directions_test.cpp measures the moments by frequency:
/// both within 5° where the sea has more than 0.3 of its peak's density.
std::vector<Octave> spreadDirections(const std::vector<Octave>& octaves, double exponent,
                                     std::size_t count);

/// The same with each octave's own exponent, finite and ≥ 0: θ follows the spread arccos r₁ of
/// each octave, and Σa² cos θ of the pairs gives their Σa² r₁.
std::vector<Octave> spreadDirections(const std::vector<Octave>& octaves,
                                     const std::function<double(const Octave&)>& exponentOf,
                                     std::size_t count);

}  // namespace seaway
