#include "surface/spectra/families.h"

#include <cmath>
#include <sstream>

#include "surface/input_error.h"

namespace seaway {
namespace {

void require(bool allowed, const char* name, double value, const char* range) {
  if (allowed && std::isfinite(value)) return;
  std::ostringstream message;
  message << name << ' ' << value << " is not allowed; must be " << range;
  throw InputError(message.str());
}

}  // namespace

double jonswapShape(double frequency, double peakFrequency, double peakEnhancement) {
  const double ratio = frequency / peakFrequency;
  const double sigma = ratio <= 1.0 ? 0.07 : 0.09;
  const double offset = (ratio - 1.0) / sigma;
  return std::pow(ratio, -5.0) * std::exp(-1.25 * std::pow(ratio, -4.0)) *
         std::pow(peakEnhancement, std::exp(-0.5 * offset * offset));
}

FrequencySpectrum jonswap(const JonswapParameters& parameters, std::size_t count) {
  require(parameters.significantWaveHeight > 0.0, "significant wave height",
          parameters.significantWaveHeight, "> 0 m");
  require(parameters.peakPeriod > 0.0, "peak period", parameters.peakPeriod, "> 0 s");
  require(parameters.peakEnhancement >= 1.0 && parameters.peakEnhancement <= 20.0,
          "peak enhancement gamma", parameters.peakEnhancement, "in [1, 20]");
  const double peakFrequency = 1.0 / parameters.peakPeriod;
  FrequencySpectrum spectrum;
  for (std::size_t i = 0; i < count; ++i) {
    const double ratio = 0.3 + (8.0 - 0.3) * static_cast<double>(i) / static_cast<double>(count - 1);
    spectrum.frequency.push_back(ratio * peakFrequency);
    spectrum.density.push_back(
        jonswapShape(spectrum.frequency.back(), peakFrequency, parameters.peakEnhancement));
  }
  const double scale = parameters.significantWaveHeight / spectrum.significantWaveHeight();
  for (double& density : spectrum.density) density *= scale * scale;
  return spectrum;
}

FrequencySpectrum piersonMoskowitz(double significantWaveHeight, double peakPeriod,
                                   std::size_t count) {
  return jonswap({significantWaveHeight, peakPeriod, 1.0}, count);
}

}  // namespace seaway
