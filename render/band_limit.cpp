#include "render/band_limit.h"

#include <algorithm>

#include "surface/constants.h"
#include "surface/field/perlin_spectrum.h"

namespace seaway::render {
namespace {

/// ⟨q²⟩ of a Perlin octave, q in cycles per cell; the density is zero beyond q = 4.
double perlinMeanSquareCycles() {
  static const double value = [] {
    constexpr int steps = 400;
    double sum = 0.0;
    for (int i = 0; i < steps; ++i) {
      const double q = 4.0 * (i + 0.5) / steps;
      sum += q * q * perlinWaveNumberDensity(q) * (4.0 / steps);
    }
    return sum;
  }();
  return value;
}

double smoothstep(double low, double high, double x) {
  const double f = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return f * f * (3.0 - 2.0 * f);
}

}  // namespace

double meanSquareSlope(const Octave& octave) {
  const double radiansPerMetre = 2.0 * pi / octave.latticeSize;
  return octave.standardDeviation * octave.standardDeviation * radiansPerMetre * radiansPerMetre *
         perlinMeanSquareCycles();
}

double coxMunkMeanSquareSlope(double windSpeed) { return 0.003 + 5.12e-3 * windSpeed; }

BandLimit::BandLimit(const WaveField& waves) {
  for (const Octave& octave : waves.octaves()) {
    const double variance = octave.standardDeviation * octave.standardDeviation;
    octaves_.push_back(
        {octave.latticeSize / perlinPeakCyclesPerCell, variance, meanSquareSlope(octave)});
    totalVariance_ += variance;
    totalSlope_ += octaves_.back().slope;
  }
}

BandLimit::Plan BandLimit::planFor(double spacing) const {
  const auto weightOf = [&](const Entry& octave) {
    return smoothstep(2.0 * spacing, 4.0 * spacing, octave.wavelength);
  };
  Plan plan;
  while (plan.kept < octaves_.size() && weightOf(octaves_[plan.kept]) > 0.999) ++plan.kept;
  // Octaves that neither raise nor tilt the sea do not keep a whole prefix alive.
  plan.fading = octaves_.size();
  while (plan.fading > plan.kept) {
    const Entry& last = octaves_[plan.fading - 1];
    const double weight = weightOf(last);
    if (weight * last.variance > 1e-4 * totalVariance_) break;
    if (weight * last.slope > 1e-3 * totalSlope_) break;
    --plan.fading;
  }

  double keptSlope = 0.0, groupSlope = 0.0, groupWeighted = 0.0;
  for (std::size_t i = 0; i < plan.fading; ++i) {
    const Entry& octave = octaves_[i];
    (i < plan.kept ? keptSlope : groupSlope) += octave.slope;
    if (i >= plan.kept) groupWeighted += octave.slope * weightOf(octave);
  }
  plan.weight = groupSlope > 0.0 ? groupWeighted / groupSlope : 0.0;
  plan.missingSlope =
      std::max(totalSlope_ - keptSlope - plan.weight * plan.weight * groupSlope, 0.0);
  return plan;
}

}  // namespace seaway::render
