#include "surface/fit/fit_options.h"

#include <cmath>

#include "surface/constants.h"
#include "surface/input_error.h"

namespace seaway::fit {

void check(const OctaveFitOptions& options) {
  if (options.octaves < 1 || options.octaves > 64) {
    throw InputError("octaves " + std::to_string(options.octaves) +
                     " is not allowed; must be in [1, 64]");
  }
  if (!(options.lacunarity > 1.0)) throw InputError("lacunarity must be > 1");
  if (!(options.depth > 0.0)) throw InputError("depth must be > 0 m");
  if (!(options.tailWeight >= 0.0)) throw InputError("tail weight must be >= 0");
  if (!(options.deviationWeight >= 0.0)) throw InputError("deviation weight must be >= 0");
  if (!(options.startScatter >= 0.0)) throw InputError("scatter of the start must be >= 0");
  if (!(options.directionalWidth > 0.0 && options.directionalWidth <= pi)) {
    throw InputError("directional width must be in (0, pi] rad");
  }
  if (options.maxIterations < 1 || options.latticeTrials < 1) {
    throw InputError("iterations and lattice trials must be >= 1");
  }
  if (options.starts < 1 || options.starts > 1000) {
    throw InputError("starts " + std::to_string(options.starts) +
                     " is not allowed; must be in [1, 1000]");
  }
}

std::optional<std::string> problemOf(const FrequencySpectrum& target) {
  if (const auto problem = target.validate()) return "the target is not valid: " + *problem;
  if (!(target.moment(0) > 0.0)) return "the target has no energy";
  return std::nullopt;
}

void summariseMoments(const FrequencySpectrum& target, OctaveFit& fit) {
  double fitted = 0.0;
  for (const Octave& octave : fit.octaves) {
    fitted += octave.standardDeviation * octave.standardDeviation;
  }
  const FrequencySpectrum& model = fit.model.energy;
  OctaveFitSummary& summary = fit.summary;
  summary.hm0Target = target.significantWaveHeight();
  summary.hm0Fit = 4.0 * std::sqrt(fitted);
  summary.hm0Band = model.significantWaveHeight();
  summary.tm02Target = target.zeroCrossingPeriod();
  summary.tm02Fit = model.zeroCrossingPeriod();
  summary.tpTarget = target.peakPeriod();
  summary.tpFit = model.peakPeriod();
}

}  // namespace seaway::fit
