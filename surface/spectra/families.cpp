#include "surface/spectra/families.h"

#include <algorithm>
#include <cmath>

#include "surface/constants.h"
#include "surface/spectra/family_support.h"

namespace seaway {
namespace {

void requireJonswap(const JonswapParameters& parameters) {
  family::requireWaveHeight(parameters.significantWaveHeight);
  family::requirePeakPeriod(parameters.peakPeriod);
  family::requireGamma(parameters.peakEnhancement);
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
  requireJonswap(parameters);
  const double fp = 1.0 / parameters.peakPeriod;
  const auto shape = [&](double f) { return jonswapShape(f, fp, parameters.peakEnhancement); };
  return family::scaledTo(family::sampledEvenly(0.3 * fp, 8.0 * fp, count, shape),
                          parameters.significantWaveHeight);
}

FrequencySpectrum piersonMoskowitz(double significantWaveHeight, double peakPeriod,
                                   std::size_t count) {
  return jonswap({significantWaveHeight, peakPeriod, 1.0}, count);
}

FrequencySpectrum piersonMoskowitzOfWind(double windSpeed, std::size_t count) {
  family::require(windSpeed > 0.0 && windSpeed <= 100.0, "wind speed", windSpeed,
                  "in (0, 100] m/s");
  constexpr double alpha = 0.0081;
  constexpr double beta = 0.74;
  const double hm0 = 2.0 * std::sqrt(alpha / beta) * windSpeed * windSpeed / standardGravity;
  const double peak = std::pow(0.8 * beta, 0.25) * standardGravity / windSpeed;  // rad/s
  return piersonMoskowitz(hm0, 2.0 * pi / peak, count);
}

double finiteDepthFactor(double frequency, double depth) {
  const double omega = std::min(2.0, 2.0 * pi * frequency * std::sqrt(depth / standardGravity));
  if (omega <= 1.0) return 0.5 * omega * omega;
  return 1.0 - 0.5 * (2.0 - omega) * (2.0 - omega);
}

FrequencySpectrum tma(const JonswapParameters& parameters, double depth, std::size_t count) {
  requireJonswap(parameters);
  if (!(depth > 0.0)) family::require(false, "water depth", depth, "> 0 m");
  FrequencySpectrum spectrum = jonswap(parameters, count);
  for (std::size_t i = 0; i < spectrum.frequency.size(); ++i) {
    spectrum.density[i] *= finiteDepthFactor(spectrum.frequency[i], depth);
  }
  return family::scaledTo(std::move(spectrum), parameters.significantWaveHeight);
}

}  // namespace seaway
