#include "sim_bridge/commands/fit_verification.h"

#include <algorithm>
#include <cmath>

#include "sim_bridge/commands/buoy.h"
#include "sim_bridge/scene/sea.h"
#include "surface/angles.h"
#include "surface/fit/field_reading.h"

namespace seaway::bridge {
namespace {

constexpr double secondsPerHour = 3600.0;

/// The bins of a spectrum within [low, high] Hz.
FrequencySpectrum within(const FrequencySpectrum& spectrum, double low, double high) {
  FrequencySpectrum part;
  for (std::size_t i = 0; i < spectrum.frequency.size(); ++i) {
    if (spectrum.frequency[i] < low || spectrum.frequency[i] > high) continue;
    part.frequency.push_back(spectrum.frequency[i]);
    part.density.push_back(spectrum.density[i]);
  }
  return part;
}

/// Standard error of T_m02 in a record of `duration` s: ½ T √(∫S²(1/m₀ − f²/m₂)² df/T).
double periodError(const FrequencySpectrum& sea, double duration) {
  const double m0 = sea.moment(0), m2 = sea.moment(2);
  FrequencySpectrum squares = sea;
  for (std::size_t i = 0; i < sea.frequency.size(); ++i) {
    const double f = sea.frequency[i];
    squares.density[i] = std::pow(sea.density[i] * (1.0 / m0 - f * f / m2), 2);
  }
  return 0.5 * sea.zeroCrossingPeriod() * std::sqrt(squares.moment(0) / duration);
}

/// Moments over a band, weighted by density.
DirectionalMoments bandMean(const FrequencySpectrum& spectrum,
                            const std::vector<DirectionalMoments>& moments, double low,
                            double high) {
  DirectionalMoments sum{0.0, 0.0, 0.0, 0.0};
  double total = 0.0;
  for (std::size_t i = 0; i < moments.size(); ++i) {
    const double f = spectrum.frequency[i], s = spectrum.density[i];
    if (f < low || f > high || !(s > 0.0) || !moments[i].hasFirst()) continue;
    sum.a1 += s * moments[i].a1;
    sum.b1 += s * moments[i].b1;
    sum.a2 += s * moments[i].a2;
    sum.b2 += s * moments[i].b2;
    total += s;
  }
  return {sum.a1 / total, sum.b1 / total, sum.a2 / total, sum.b2 / total};
}

/// Direction and spread about the target's peak: in the bins within 10 % of it, or its own.
void readDirections(const DirectionalSpectrum& target, const OctaveFit& fit, double duration,
                    BuoyVerification& result) {
  const auto peak = static_cast<std::size_t>(
      std::max_element(target.energy.density.begin(), target.energy.density.end()) -
      target.energy.density.begin());
  const double f = target.energy.frequency[peak];
  const double low = 0.9 * f, high = 1.1 * f;
  const DirectionalMoments asked = bandMean(target.energy, target.moments, low, high);
  const BuoyAnalysis& analysis = result.analysis;
  const DirectionalMoments read = bandMean(analysis.spectrum, analysis.directions, low, high);
  if (!asked.hasFirst() || !read.hasFirst()) return;
  const DirectionalMoments model = bandMean(fit.model.energy, fit.model.moments, low, high);
  const double nu = 2.0 * (high - low) * duration;
  const double r1 = model.r1(), r2 = std::hypot(model.a2, model.b2);
  const double from = compassFromFromToward(asked.meanDirection());
  const double turned =
      degreesFromRadians(std::remainder(asked.meanDirection() - read.meanDirection(), 2.0 * pi));
  result.quantities.push_back({"direction at the peak, from", "deg", from, from + turned,
                               degreesFromRadians(std::sqrt((1.0 - r2) / nu) / r1)});
  const double along = std::sqrt(std::max(1.0 + r2 - 2.0 * r1 * r1, 0.0) / nu);
  result.quantities.push_back({"spread at the peak", "deg", degreesFromRadians(asked.spread()),
                               degreesFromRadians(read.spread()),
                               degreesFromRadians(along / std::max(model.spread(), 1e-3))});
}

}  // namespace

double ReadBack::deviations() const { return std::abs(read - asked) / standardError; }

BuoyVerification verifyWithBuoy(const DirectionalSpectrum& target, const OctaveFit& fit,
                                double depth, std::uint64_t seed, double hours) {
  WaveFieldSettings settings;
  settings.seed = seed;
  settings.depth = depth;
  const Sea sea{Geodesy({0.0, 0.0, 0.0}),
                SeaLevel(0.0),
                WaterSurface(WaveField(fit.octaves, settings)),
                fit.summary.hm0Target,
                {}};
  const double low = target.energy.lowest(), high = target.energy.highest();
  // Twice Nyquist's rate over the band, and not below a real buoy's 2 Hz.
  const double rate = std::clamp(4.0 * high, 2.0, 50.0);
  const double duration = hours * secondsPerHour;
  const auto count = static_cast<std::size_t>(duration * rate);
  BuoyVerification result;
  result.hours = hours;
  result.analysis = analyseBuoy(recordBuoy(sea, glm::dvec2(0.0), rate, count),
                                {.segment = std::min(256.0, 0.5 * duration)});
  const BuoyAnalysis& analysis = result.analysis;
  result.quantities.push_back({"H_m0", "m", fit.summary.hm0Target, analysis.significantWaveHeight,
                               analysis.significantWaveHeightError});
  const FrequencySpectrum band = within(analysis.spectrum, low, high);
  if (band.frequency.size() > 2) {
    result.quantities.push_back({"T_m02", "s", fit.summary.tm02Target, band.zeroCrossingPeriod(),
                                 periodError(fit.model.energy, duration)});
  }
  if (!target.moments.empty()) readDirections(target, fit, duration, result);
  result.agrees = std::all_of(result.quantities.begin(), result.quantities.end(),
                              [](const ReadBack& q) { return q.deviations() <= 3.0; });
  return result;
}

}  // namespace seaway::bridge
