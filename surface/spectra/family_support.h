#pragma once

#include <cmath>
#include <cstddef>
#include <sstream>
#include <vector>

#include "surface/input_error.h"
#include "surface/spectra/frequency_spectrum.h"

/// What the spectral families share. Internal to surface/spectra.
namespace seaway::family {

/// Throws InputError "NAME VALUE is not allowed; must be RANGE" where `allowed` does not hold.
inline void require(bool allowed, const char* name, double value, const char* range) {
  if (allowed && std::isfinite(value)) return;
  std::ostringstream message;
  message << name << ' ' << value << " is not allowed; must be " << range;
  throw InputError(message.str());
}

inline void requireWaveHeight(double hm0) {
  require(hm0 > 0.0, "significant wave height", hm0, "> 0 m");
}
inline void requirePeakPeriod(double tp) { require(tp > 0.0, "peak period", tp, "> 0 s"); }
inline void requireGamma(double gamma) {
  require(gamma >= 1.0 && gamma <= 20.0, "peak enhancement gamma", gamma, "in [1, 20]");
}
inline void requireCount(std::size_t count) {
  require(count >= 2, "number of frequencies", static_cast<double>(count), ">= 2");
}

/// `density(f)` on `count` frequencies from `lowest` to `highest` Hz, evenly spaced.
template <class Density>
FrequencySpectrum sampledEvenly(double lowest, double highest, std::size_t count,
                                const Density& density) {
  requireCount(count);
  FrequencySpectrum spectrum;
  for (std::size_t i = 0; i < count; ++i) {
    const double fraction = static_cast<double>(i) / static_cast<double>(count - 1);
    spectrum.frequency.push_back(lowest + (highest - lowest) * fraction);
    spectrum.density.push_back(density(spectrum.frequency.back()));
  }
  return spectrum;
}

/// The same, evenly spaced in ln f: equally fine at two peaks far apart.
template <class Density>
FrequencySpectrum sampledByRatio(double lowest, double highest, std::size_t count,
                                 const Density& density) {
  FrequencySpectrum spectrum =
      sampledEvenly(std::log(lowest), std::log(highest), count, [](double) { return 0.0; });
  for (std::size_t i = 0; i < count; ++i) {
    spectrum.frequency[i] = std::exp(spectrum.frequency[i]);
    spectrum.density[i] = density(spectrum.frequency[i]);
  }
  return spectrum;
}

/// `spectrum` scaled to an H_m0 over its own band.
inline FrequencySpectrum scaledTo(FrequencySpectrum spectrum, double hm0) {
  const double scale = hm0 / spectrum.significantWaveHeight();
  for (double& density : spectrum.density) density *= scale * scale;
  return spectrum;
}

}  // namespace seaway::family
