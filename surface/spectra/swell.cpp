#include "surface/spectra/swell.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "surface/spectra/family_support.h"

namespace seaway {

FrequencySpectrum gaussianSwell(double significantWaveHeight, double peakPeriod, double width,
                                std::size_t count) {
  family::requireWaveHeight(significantWaveHeight);
  family::requirePeakPeriod(peakPeriod);
  const double peak = 1.0 / peakPeriod;
  family::require(width > 0.0 && width <= 0.5 * peak, "swell width", width, "in (0, 0.5/Tp] Hz");
  const auto bell = [&](double f) { return std::exp(-0.5 * std::pow((f - peak) / width, 2.0)); };
  // A frequency of 0 is no wave: a thousandth of the peak is the longest one kept.
  return family::scaledTo(family::sampledEvenly(std::max(1e-3 * peak, peak - 5.0 * width),
                                                peak + 5.0 * width, count, bell),
                          significantWaveHeight);
}

}  // namespace seaway
