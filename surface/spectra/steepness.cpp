#include "surface/spectra/steepness.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "surface/constants.h"
#include "surface/dispersion.h"

namespace seaway {

double meanPeriod(std::span<const Octave> octaves, double depth) {
  double m0 = 0.0, m2 = 0.0;
  for (const Octave& octave : octaves) {
    const double variance = octave.standardDeviation * octave.standardDeviation;
    if (variance == 0.0) continue;
    const double omega = angularFrequency(2.0 * pi / dominantWavelength(octave), depth);
    m0 += variance;
    m2 += variance * omega * omega;
  }
  if (m2 <= 0.0) return std::numeric_limits<double>::quiet_NaN();
  return 2.0 * pi * std::sqrt(m0 / m2);
}

double averageSteepness(double hm0, double tm02) {
  return 2.0 * pi * hm0 / (standardGravity * tm02 * tm02);
}

double limitingSteepness(double tm02) {
  const double share = std::clamp((tm02 - 6.0) / (12.0 - 6.0), 0.0, 1.0);
  return std::lerp(1.0 / 10.0, 1.0 / 15.0, share);
}

}  // namespace seaway
