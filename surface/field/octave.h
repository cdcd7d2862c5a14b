#pragma once

#include <cstdint>
#include <limits>

namespace seaway {

/// The kinds of octave a wave field adds up.
enum class OctaveKind : std::uint8_t {
  group,    ///< a lattice-noise envelope at the group speed on a carrier at the phase speed
  perlin,   ///< drifting three-dimensional lattice noise, the third dimension being time
  regular,  ///< one sine wave
};

/// One octave ηᵢ of the field η = Σ ηᵢ: what distinguishes it, apart from the scene's seed.
/// The makers below fill in what a kind needs; a field checks it.
struct Octave {
  OctaveKind kind = OctaveKind::group;
  double standardDeviation = 0.0;  ///< of the octave's height, m, ≥ 0
  double toward = 0.0;             ///< where it goes, rad counter-clockwise from east

  // group and regular
  double waveNumber = 0.0;   ///< of the carrier, rad/m, > 0
  double phase = 0.0;        ///< of a regular wave: height is √2 a cos(k·x − ωt + phase), rad
  double lengthAlong = 0.0;  ///< ℓ∥, cell of a group's envelope along `toward`, m, > 0
  double lengthAcross = 0.0;  ///< ℓ⊥, cell of a group's envelope along the crests, m, > 0

  // perlin
  double latticeSize = 0.0;  ///< λᵢ, side of a lattice cell, m, > 0
  double driftSpeed = 0.0;   ///< m/s along `toward`, without the current
  double boilTime = 0.0;     ///< τᵢ, lattice cell in time, s, > 0
};

/// Spectrum of a group octave at a fixed point: its full width at half maximum in frequency is this
/// many times c_g/ℓ∥, and across the crests, in wave number, this many cycles per ℓ⊥.
inline constexpr double groupBandCycles = 0.692;

/// A group octave by what a buoy sees of it.
///
/// `frequency` Hz and `bandwidth` Hz (full width at half maximum of its spectrum at a fixed point),
/// both > 0; `directionalWidth` rad, (0, π]: full width at half maximum over direction.
Octave makeGroupOctave(double standardDeviation, double frequency, double bandwidth, double toward,
                       double directionalWidth,
                       double depth = std::numeric_limits<double>::infinity());

/// A regular wave of `amplitude` m ≥ 0: height = amplitude · cos(k·x − ωt + phase).
Octave makeRegularWave(double amplitude, double frequency, double toward, double phase = 0.0,
                       double depth = std::numeric_limits<double>::infinity());

/// A Perlin octave that moves as the waves at its spectral peak do: it drifts at their phase speed
/// and boils in half their period. (The kind has no dispersion of its own.)
///
/// `standardDeviation` m ≥ 0, `latticeSize` m > 0, `toward` rad, `depth` m > 0 or infinite.
Octave makePerlinOctave(double standardDeviation, double latticeSize, double toward,
                        double depth = std::numeric_limits<double>::infinity());

/// What a buoy sees of a group octave or regular wave: the arguments of its maker.
struct WaveBand {
  double frequency = 0.0;         ///< Hz, without current
  double bandwidth = 0.0;         ///< Hz; 0 for a regular wave
  double directionalWidth = 0.0;  ///< rad; 0 for a regular wave
};
WaveBand bandOf(const Octave& octave, double depth = std::numeric_limits<double>::infinity());

/// Wavelength at the octave's spectral peak, m.
double dominantWavelength(const Octave& octave);

/// Mean-square slope, both axes together: closed form from the octave's spectrum.
double meanSquareSlope(const Octave& octave);

/// Distance beyond which the octave's heights are independent, m; infinite for a regular wave.
double correlationLength(const Octave& octave);

}  // namespace seaway
