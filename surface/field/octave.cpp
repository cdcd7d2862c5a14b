#include "surface/field/octave.h"

#include <cmath>

#include "surface/constants.h"
#include "surface/dispersion.h"
#include "surface/field/perlin_spectrum.h"

namespace seaway {
namespace {

/// ⟨q²⟩ of a Perlin octave, q in cycles per cell; the density is zero beyond q = 4.
double perlinMeanSquareCycles() {
  static const double value = [] {
    constexpr int steps = 400;
    double sum = 0.0;
    for (int i = 0; i < steps; ++i) {
      const double q = 4.0 * (i + 0.5) / steps;
      sum += q * q * perlinWaveNumberDensity(q) * (4.0 / steps);
    }
    return sum;
  }();
  return value;
}

/// Mean-square slope of a group's envelope of unit variance along one axis, per cell: the mean of
/// the blending angle's squared rate, (15π/16)² ∫(1 − s²)⁴ ds over a cell.
constexpr double envelopeMeanSquareSlope = 225.0 / 256.0 * pi * pi * 128.0 / 315.0;

}  // namespace

Octave makeGroupOctave(double standardDeviation, double frequency, double bandwidth, double toward,
                       double directionalWidth, double depth) {
  Octave octave;
  octave.kind = OctaveKind::group;
  octave.standardDeviation = standardDeviation;
  octave.toward = toward;
  octave.waveNumber = waveNumber(2.0 * pi * frequency, depth);
  octave.lengthAlong = groupBandCycles * groupSpeed(octave.waveNumber, depth) / bandwidth;
  octave.lengthAcross = groupBandCycles * 2.0 * pi / (octave.waveNumber * directionalWidth);
  return octave;
}

Octave makeRegularWave(double amplitude, double frequency, double toward, double phase,
                       double depth) {
  Octave octave;
  octave.kind = OctaveKind::regular;
  octave.standardDeviation = amplitude / std::sqrt(2.0);
  octave.toward = toward;
  octave.waveNumber = waveNumber(2.0 * pi * frequency, depth);
  octave.phase = phase;
  return octave;
}

Octave makePerlinOctave(double standardDeviation, double latticeSize, double toward, double depth) {
  Octave octave;
  octave.kind = OctaveKind::perlin;
  octave.standardDeviation = standardDeviation;
  octave.latticeSize = latticeSize;
  octave.toward = toward;
  const double k = 2.0 * pi * perlinPeakCyclesPerCell / latticeSize;
  octave.driftSpeed = phaseSpeed(k, depth);
  octave.boilTime = pi / angularFrequency(k, depth);
  return octave;
}

WaveBand bandOf(const Octave& octave, double depth) {
  WaveBand band;
  band.frequency = angularFrequency(octave.waveNumber, depth) / (2.0 * pi);
  if (octave.kind != OctaveKind::group) return band;
  band.bandwidth = groupBandCycles * groupSpeed(octave.waveNumber, depth) / octave.lengthAlong;
  band.directionalWidth = groupBandCycles * 2.0 * pi / (octave.waveNumber * octave.lengthAcross);
  return band;
}

double dominantWavelength(const Octave& octave) {
  if (octave.kind == OctaveKind::perlin) return octave.latticeSize / perlinPeakCyclesPerCell;
  return 2.0 * pi / octave.waveNumber;
}

double meanSquareSlope(const Octave& octave) {
  const double variance = octave.standardDeviation * octave.standardDeviation;
  if (octave.kind == OctaveKind::perlin) {
    const double radiansPerMetre = 2.0 * pi / octave.latticeSize;
    return variance * radiansPerMetre * radiansPerMetre * perlinMeanSquareCycles();
  }
  const double carrier = octave.waveNumber * octave.waveNumber;
  if (octave.kind == OctaveKind::regular) return variance * carrier;
  return variance * (carrier + envelopeMeanSquareSlope / (octave.lengthAlong * octave.lengthAlong) +
                     envelopeMeanSquareSlope / (octave.lengthAcross * octave.lengthAcross));
}

double correlationLength(const Octave& octave) {
  if (octave.kind == OctaveKind::perlin) return octave.latticeSize;
  if (octave.kind == OctaveKind::regular) return std::numeric_limits<double>::infinity();
  return std::fmax(octave.lengthAlong, octave.lengthAcross);
}

}  // namespace seaway
