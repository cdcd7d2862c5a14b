#include "surface/spectra/two_peak_families.h"

#include <algorithm>
#include <cmath>

#include "surface/constants.h"
#include "surface/spectra/family_support.h"

namespace seaway {
namespace {

void requirePart(const OchiHubblePart& part) {
  family::require(part.significantWaveHeight >= 0.0, "significant wave height",
                  part.significantWaveHeight, ">= 0 m");
  family::requirePeakPeriod(part.peakPeriod);
  family::require(part.shape > 0.0 && part.shape <= 20.0, "shape lambda", part.shape, "in (0, 20]");
}

template <class Density>
FrequencySpectrum twoPeaks(double periodA, double periodB, std::size_t count,
                           const Density& density) {
  const auto [shorter, longer] = std::minmax(periodA, periodB);
  return family::sampledByRatio(0.3 / longer, 8.0 / shorter, count, density);
}

/// Share of the primary system's height; `offset` is T_p's distance from T_f in [0, 1].
double primaryShare(double offset, double least, double width) {
  return least + (1.0 - least) * std::exp(-offset * offset / (width * width));
}

double peakEnhancementOf(double height, double period) {
  return 35.0 * std::pow(2.0 * pi / standardGravity * height / (period * period), 6.0 / 7.0);
}

}  // namespace

double ochiHubbleDensity(double frequency, const OchiHubblePart& part) {
  // In logarithms: B^λ and ω^(4λ+1) leave the range of double long before their ratio does.
  const double fourLambda = 4.0 * part.shape;
  const double logRatio = std::log(frequency * part.peakPeriod);  // ω/ω_p
  const double factor = 0.25 * (fourLambda + 1.0);
  const double logShape = part.shape * std::log(factor) - std::lgamma(part.shape) -
                          (fourLambda + 1.0) * logRatio - factor * std::exp(-4.0 * logRatio);
  const double height = part.significantWaveHeight;
  return 0.25 * height * height * part.peakPeriod * std::exp(logShape);
}

FrequencySpectrum ochiHubble(const OchiHubblePart& swell, const OchiHubblePart& windSea,
                             std::size_t count) {
  requirePart(swell);
  requirePart(windSea);
  const double hm0 = std::hypot(swell.significantWaveHeight, windSea.significantWaveHeight);
  family::requireWaveHeight(hm0);
  const auto density = [&](double f) {
    return ochiHubbleDensity(f, swell) + ochiHubbleDensity(f, windSea);
  };
  return family::scaledTo(twoPeaks(swell.peakPeriod, windSea.peakPeriod, count, density), hm0);
}

FrequencySpectrum ochiHubbleMostProbable(double hm0, std::size_t count) {
  family::require(hm0 > 0.0 && hm0 <= 20.0, "significant wave height", hm0, "in (0, 20] m");
  const OchiHubblePart swell{0.84 * hm0, 2.0 * pi / (0.70 * std::exp(-0.046 * hm0)), 3.0};
  const OchiHubblePart windSea{0.54 * hm0, 2.0 * pi / (1.15 * std::exp(-0.039 * hm0)),
                               1.54 * std::exp(-0.062 * hm0)};
  return family::scaledTo(ochiHubble(swell, windSea, count), hm0);
}

TorsethaugenSystems torsethaugenSystems(double hm0, double peakPeriod) {
  family::requireWaveHeight(hm0);
  family::requirePeakPeriod(peakPeriod);
  const double fullyDeveloped = 6.6 * std::cbrt(hm0);  // T_f
  TorsethaugenSystems systems;
  systems.windDominated = peakPeriod <= fullyDeveloped;
  systems.primaryPeriod = peakPeriod;
  if (systems.windDominated) {
    const double shortest = 2.0 * std::sqrt(hm0);
    // Above 1: steeper than the model knows (or T_l > T_f, H_m0 > 1292 m).
    const double offset =
        std::clamp((fullyDeveloped - peakPeriod) / (fullyDeveloped - shortest), 0.0, 1.0);
    const double share = primaryShare(offset, 0.7, 0.5);
    systems.primaryHeight = share * hm0;
    systems.peakEnhancement = peakEnhancementOf(systems.primaryHeight, peakPeriod);
    systems.secondaryHeight = hm0 * std::sqrt(1.0 - share * share);
    systems.secondaryPeriod = fullyDeveloped + 2.0;
  } else {
    constexpr double longest = 25.0;
    const double offset =
        fullyDeveloped < longest
            ? std::min(1.0, (peakPeriod - fullyDeveloped) / (longest - fullyDeveloped))
            : 1.0;
    const double share = primaryShare(offset, 0.6, 0.3);
    systems.primaryHeight = share * hm0;
    systems.peakEnhancement = peakEnhancementOf(hm0, fullyDeveloped) * (1.0 + 6.0 * offset);
    systems.secondaryHeight = hm0 * std::sqrt(1.0 - share * share);
    systems.secondaryPeriod = 6.6 * std::cbrt(systems.secondaryHeight);
  }
  systems.peakEnhancement = std::max(1.0, systems.peakEnhancement);
  return systems;
}

double torsethaugenDensity(double frequency, const TorsethaugenSystems& systems) {
  const auto shape = [](double ratio) {
    const double inverse = 1.0 / (ratio * ratio * ratio * ratio);
    return 3.26 * inverse * std::exp(-inverse);
  };
  const double gamma = systems.peakEnhancement;
  const double ratio = frequency * systems.primaryPeriod;
  const double offset = (ratio - 1.0) / (ratio < 1.0 ? 0.07 : 0.09);
  const double peak = (1.0 + 1.1 * std::pow(std::log(gamma), 1.19)) / gamma *
                      std::pow(gamma, std::exp(-0.5 * offset * offset));
  const auto energy = [](double height, double period) { return height * height * period / 16.0; };
  double density = energy(systems.primaryHeight, systems.primaryPeriod) * shape(ratio) * peak;
  if (systems.secondaryHeight > 0.0) {
    density += energy(systems.secondaryHeight, systems.secondaryPeriod) *
               shape(frequency * systems.secondaryPeriod);
  }
  return density;
}

FrequencySpectrum torsethaugen(double hm0, double peakPeriod, std::size_t count) {
  const TorsethaugenSystems systems = torsethaugenSystems(hm0, peakPeriod);
  const double other = systems.secondaryHeight > 0.0 ? systems.secondaryPeriod : peakPeriod;
  const auto density = [&](double f) { return torsethaugenDensity(f, systems); };
  return family::scaledTo(twoPeaks(peakPeriod, other, count, density), hm0);
}

}  // namespace seaway
