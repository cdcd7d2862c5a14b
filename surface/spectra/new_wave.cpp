#include "surface/spectra/new_wave.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "surface/angles.h"
#include "surface/dispersion.h"
#include "surface/input_error.h"

namespace seaway {

std::vector<Octave> newWave(const FrequencySpectrum& spectrum, const NewWaveOptions& options) {
  if (const auto problem = spectrum.validate()) throw InputError("focused group: " + *problem);
  if (!(options.crestHeight > 0.0)) throw InputError("focused group: crest height must be > 0 m");
  if (options.components < 2) throw InputError("focused group: components must be >= 2");
  if (!(options.depth > 0.0)) throw InputError("focused group: depth must be > 0 m");

  const auto count = static_cast<double>(options.components);
  const double step = (spectrum.highest() - spectrum.lowest()) / count;
  std::vector<double> frequencies, densities;
  double total = 0.0;
  for (std::size_t n = 0; n < options.components; ++n) {
    frequencies.push_back(spectrum.lowest() + (static_cast<double>(n) + 0.5) * step);
    densities.push_back(spectrum.at(frequencies.back()));
    total += densities.back();
  }
  if (!(total > 0.0)) throw InputError("focused group: the spectrum has no energy");

  std::vector<Octave> waves;
  for (std::size_t n = 0; n < options.components; ++n) {
    const double omega = 2.0 * pi * frequencies[n];
    const glm::dvec2 k = unitVector(options.toward) * waveNumber(omega, options.depth);
    const double phase = omega * options.time - glm::dot(k, options.place);
    waves.push_back(makeRegularWave(options.crestHeight * densities[n] / total, frequencies[n],
                                    options.toward, std::remainder(phase, 2.0 * pi),
                                    options.depth));
  }
  return waves;
}

}  // namespace seaway
