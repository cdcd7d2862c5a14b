#include "surface/fit/field_reading.h"

#include <cmath>

#include "surface/fit/group_solve.h"

namespace seaway {

namespace fit {

GroupState stateOf(std::span<const Octave> octaves, double depth) {
  GroupState state;
  state.depth = depth;
  for (const Octave& octave : octaves) {
    if (octave.kind != OctaveKind::group) continue;
    const WaveBand band = bandOf(octave, depth);
    state.variance.push_back(octave.standardDeviation * octave.standardDeviation);
    state.shape.push_back({band.frequency, band.bandwidth, octave.toward, band.directionalWidth});
  }
  return state;
}

}  // namespace fit

FieldReading readField(std::span<const Octave> octaves, const std::vector<double>& frequency,
                       std::size_t directions, double depth) {
  fit::GroupTarget places;
  places.frequency = frequency;
  for (const double f : frequency) places.waveNumber.push_back(waveNumber(2.0 * pi * f, depth));
  for (std::size_t d = 0; d < directions; ++d) {
    places.direction.push_back(2.0 * pi * static_cast<double>(d) / static_cast<double>(directions));
  }
  places.grid.resize(frequency.size() * directions);
  fit::GroupCurves curves = fit::curvesOf(places, fit::stateOf(octaves, depth));
  FieldReading result;
  DirectionalSpectrum& spectrum = result.spectrum;
  spectrum.energy.frequency = frequency;
  spectrum.direction = places.direction;
  spectrum.density = std::move(curves.grid);
  double energy = 0.0, squares = 0.0;
  for (std::size_t p = 0; p < frequency.size(); ++p) {
    const fit::GroupReading<double>& r = curves.reading[p];
    const double mixed = std::sqrt(r.energy * r.slopes);
    spectrum.energy.density.push_back(r.energy);
    spectrum.moments.push_back(
        {r.east / mixed, r.north / mixed, r.difference / r.slopes, r.cross / r.slopes});
    const double ratio = std::sqrt(r.slopes / r.energy);
    result.waveNumber.push_back(ratio * places.waveNumber[p]);
    const double width =
        frequency[std::min(p + 1, frequency.size() - 1)] - frequency[p > 0 ? p - 1 : p];
    if (!(r.energy > 0.0)) continue;
    energy += width * r.energy;
    squares += width * r.energy * (ratio - 1.0) * (ratio - 1.0);
  }
  result.waveNumberDeviation = energy > 0.0 ? std::sqrt(squares / energy) : 0.0;
  return result;
}

}  // namespace seaway
