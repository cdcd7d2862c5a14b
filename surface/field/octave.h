#pragma once

#include <cstdint>
#include <limits>

namespace seaway {

/// The kinds of octave a wave field adds up.
enum class OctaveKind : std::uint8_t {
  perlin,  ///< drifting three-dimensional lattice noise, the third dimension being time
};

/// One octave ηᵢ of the field η = Σ ηᵢ: what distinguishes it, apart from the scene's seed.
struct Octave {
  OctaveKind kind = OctaveKind::perlin;
  double standardDeviation = 0.0;  ///< of the octave's height, m, ≥ 0
  double latticeSize = 1.0;        ///< λᵢ, side of a lattice cell, m, > 0
  double toward = 0.0;             ///< drift direction, rad counter-clockwise from east
  double driftSpeed = 0.0;         ///< m/s along `toward`, without the current
  double boilTime = 1.0;           ///< τᵢ, lattice cell in time, s, > 0
};

/// A Perlin octave that moves as the waves at its spectral peak do: it drifts at their phase speed
/// and boils in half their period. (The kind has no dispersion of its own; TECHNIQUES, "Perlin
/// octaves as a sea".)
///
/// `standardDeviation` m ≥ 0, `latticeSize` m > 0, `toward` rad, `depth` m > 0 or infinite.
Octave makePerlinOctave(double standardDeviation, double latticeSize, double toward,
                        double depth = std::numeric_limits<double>::infinity());

}  // namespace seaway
