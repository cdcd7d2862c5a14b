#include "surface/spectra/spreading.h"

#include <algorithm>
#include <cmath>

#include "surface/constants.h"
#include "surface/spectra/family_support.h"

namespace seaway {
namespace {

/// ln cos²ˢ(θ/2): finite where the power itself underflows.
double logCosinePower(double angle, double s) {
  if (s == 0.0) return 0.0;
  return 2.0 * s * std::log(std::abs(std::cos(0.5 * angle)));
}

double logWrappedNormal(double angle, double sigma) {
  const double wrapped = std::remainder(angle, 2.0 * pi);
  const double nearest = -0.5 * wrapped * wrapped / (sigma * sigma);
  // σ ≤ π: the ninth image weighs e⁻¹²⁸.
  double others = 0.0;
  for (int turn = 1; turn <= 8; ++turn) {
    for (const double image : {wrapped + 2.0 * pi * turn, wrapped - 2.0 * pi * turn}) {
      others += std::exp(-0.5 * image * image / (sigma * sigma) - nearest);
    }
  }
  return nearest + std::log1p(others);
}

/// `logDensity(frequency, angle)` need not be normalised.
template <class LogDensity>
DirectionalSpectrum spread(const FrequencySpectrum& energy, double toward, std::size_t directions,
                           const LogDensity& logDensity) {
  if (const auto wrong = energy.validate()) throw InputError(*wrong);
  family::require(directions >= 3 && directions <= 3600, "number of directions",
                  static_cast<double>(directions), "in [3, 3600]");
  family::require(true, "mean direction", toward, "finite");
  DirectionalSpectrum spectrum;
  spectrum.energy = energy;
  spectrum.direction = evenDirections(directions);
  const double width = 2.0 * pi / static_cast<double>(directions);
  std::vector<double> weights(directions);
  for (std::size_t f = 0; f < energy.frequency.size(); ++f) {
    for (std::size_t d = 0; d < directions; ++d) {
      weights[d] = logDensity(energy.frequency[f], spectrum.direction[d] - toward);
    }
    const double highest = *std::max_element(weights.begin(), weights.end());
    double sum = 0.0;
    for (double& weight : weights) sum += weight = std::exp(weight - highest);
    for (const double weight : weights) {
      spectrum.density.push_back(energy.density[f] * weight / (sum * width));
    }
  }
  spectrum.integrateGrid();
  spectrum.energy = energy;  // not its rounded integral
  return spectrum;
}

}  // namespace

double cosinePowerSpreading(double angle, double s) {
  const double logScale = (2.0 * s - 1.0) * std::log(2.0) - std::log(pi) +
                          2.0 * std::lgamma(s + 1.0) - std::lgamma(2.0 * s + 1.0);
  return std::exp(logScale + logCosinePower(angle, s));
}

double wrappedNormalSpreading(double angle, double sigma) {
  return std::exp(logWrappedNormal(angle, sigma)) / (sigma * std::sqrt(2.0 * pi));
}

double mitsuyasuExponent(double frequency, double peakFrequency, double peakExponent) {
  const double ratio = frequency / peakFrequency;
  return peakExponent * std::pow(ratio, ratio <= 1.0 ? 5.0 : -2.5);
}

double mitsuyasuPeakExponent(double peakFrequency, double windSpeed) {
  return 11.5 * std::pow(2.0 * pi * peakFrequency * windSpeed / standardGravity, -2.5);
}

std::vector<double> evenDirections(std::size_t count) {
  std::vector<double> directions(count);
  for (std::size_t d = 0; d < count; ++d) {
    directions[d] = 2.0 * pi * static_cast<double>(d) / static_cast<double>(count);
  }
  return directions;
}

DirectionalSpectrum spreadByCosinePower(const FrequencySpectrum& energy, double toward, double s,
                                        std::size_t directions) {
  family::require(s >= 0.0 && s <= 1e6, "spreading exponent s", s, "in [0, 1e6]");
  return spread(energy, toward, directions,
                [&](double, double angle) { return logCosinePower(angle, s); });
}

DirectionalSpectrum spreadByMitsuyasu(const FrequencySpectrum& energy, double toward,
                                      double peakFrequency, double peakExponent,
                                      std::size_t directions) {
  family::require(peakFrequency > 0.0, "peak frequency", peakFrequency, "> 0 Hz");
  family::require(peakExponent > 0.0 && peakExponent <= 1e6, "spreading exponent s at the peak",
                  peakExponent, "in (0, 1e6]");
  return spread(energy, toward, directions, [&](double f, double angle) {
    return logCosinePower(angle, mitsuyasuExponent(f, peakFrequency, peakExponent));
  });
}

DirectionalSpectrum spreadByWrappedNormal(const FrequencySpectrum& energy, double toward,
                                          double sigma, std::size_t directions) {
  family::require(sigma > 0.0 && sigma <= pi, "directional standard deviation", sigma,
                  "in (0, pi] rad");
  return spread(energy, toward, directions,
                [&](double, double angle) { return logWrappedNormal(angle, sigma); });
}

DirectionalSpectrum unidirectional(const FrequencySpectrum& energy, double toward) {
  if (const auto wrong = energy.validate()) throw InputError(*wrong);
  family::require(true, "mean direction", toward, "finite");
  const DirectionalMoments one{std::cos(toward), std::sin(toward), std::cos(2.0 * toward),
                               std::sin(2.0 * toward)};
  return {energy, std::vector<DirectionalMoments>(energy.frequency.size(), one), {}, {}};
}

}  // namespace seaway
