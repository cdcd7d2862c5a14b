#include "sim_bridge/cost/rivals/seas.h"

#include <cmath>

#include "sim_bridge/cost/rivals/sine_sum.h"
#include "surface/fit/octave_fit.h"
#include "surface/spectra/families.h"

namespace seaway::rivals {
namespace {

FittedOctaves fitted(const OctaveFit& fit) { return {fit.octaves, fit.summary.residualL2}; }

double relative(double difference, double whole) { return std::sqrt(difference / whole); }

}  // namespace

FittedOctaves groupOctaves(const FrequencySpectrum& target, int count) {
  OctaveFitOptions options;
  options.octaves = count;
  return fitted(fitGroupOctaves(target, options));
}

FittedOctaves perlinOctaves(const FrequencySpectrum& target, int count) {
  OctaveFitOptions options;
  options.octaves = count;
  return fitted(fitPerlinOctaves(target, options));
}

FittedOctaves halvingPerlinOctaves(const JonswapParameters& sea) {
  const FrequencySpectrum target = jonswap(sea);
  const double peak = 1.0 / sea.peakPeriod;
  const double scale = target.at(peak) / jonswapShape(peak, peak, sea.peakEnhancement);
  FrequencySpectrum longer;
  for (int i = 0; i < 1200; ++i) {
    const double f = peak * (0.3 + 19.7 * i / 1199.0);
    longer.frequency.push_back(f);
    longer.density.push_back(scale * jonswapShape(f, peak, sea.peakEnhancement));
  }
  return fitted(fitPerlinOctaves(longer));
}

std::vector<Octave> regularWaves(const FrequencySpectrum& target, int count) {
  std::vector<Octave> octaves;
  for (const SineComponent& c : sineComponents(target, static_cast<std::size_t>(count))) {
    octaves.push_back(makeRegularWave(c.amplitude, c.frequency, c.toward, c.phase));
  }
  return octaves;
}

double sineResidual(const FrequencySpectrum& target, std::size_t count) {
  const std::vector<double> edges = bandEdges(target, count);
  const auto components = sineComponents(target, count);
  double difference = 0.0, whole = 0.0;
  constexpr int steps = 100;
  for (std::size_t n = 0; n < count; ++n) {
    const double width = edges[n + 1] - edges[n];
    const double model = 0.5 * components[n].amplitude * components[n].amplitude / width;
    for (int i = 0; i < steps; ++i) {
      const double density = target.at(edges[n] + (i + 0.5) / steps * width);
      difference += (model - density) * (model - density) * width / steps;
      whole += density * density * width / steps;
    }
  }
  return relative(difference, whole);
}

double bandResidual(const FrequencySpectrum& target, const std::vector<double>& variance) {
  const double width = (target.highest() - target.lowest()) / static_cast<double>(variance.size());
  double difference = 0.0, whole = 0.0;
  constexpr int steps = 100;
  for (std::size_t n = 0; n < variance.size(); ++n) {
    double density = 0.0;
    for (int i = 0; i < steps; ++i) {
      const double f = target.lowest() + (static_cast<double>(n) + (i + 0.5) / steps) * width;
      density += target.at(f) / steps;
    }
    difference += std::pow(variance[n] / width - density, 2);
    whole += density * density;
  }
  return relative(difference, whole);
}

}  // namespace seaway::rivals
