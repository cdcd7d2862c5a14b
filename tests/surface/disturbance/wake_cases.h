#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "surface/disturbance/wake_system.h"

/// Vessels under way that tests of the wake system share.
namespace seaway::test {

inline HullFootprint launch() { return HullFootprint::wigley(12.0, 3.5, 0.8); }

/// Windows a quarter as large as the standard ones, to be quick.
inline WakeSystemSettings small() {
  WakeSystemSettings settings;
  WakeLevel fine, coarse;
  fine.step = 0.1;
  fine.window.cellSize = 0.5;
  fine.window.cells = 128;
  fine.window.modes = 64;
  fine.window.band = {2.0, 4.0, 8.0, 16.0};
  coarse.step = 0.2;
  coarse.window.cellSize = 2.0;
  coarse.window.cells = 128;
  coarse.window.modes = 64;
  coarse.window.band = {8.0, 16.0};
  settings.cascade = {fine, coarse};
  return settings;
}

inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();

inline WakePose sailing(double t, double speed = 4.0) { return {t, {speed * t, 0.0}, 0.0, 1.0}; }

/// Someone beside the course.
inline std::vector<WakeListener> beside(double x) { return {{{x, 20.0}, 5.0, 0}}; }

inline std::vector<glm::dvec2> astern(double x) {
  std::vector<glm::dvec2> points;
  for (int i = 0; i < 12; ++i) {
    for (int j = -3; j <= 3; ++j) points.emplace_back(x - 8.0 - 1.5 * i, 2.1 * j);
  }
  return points;
}

inline std::vector<SurfaceSample> sampled(const DisturbanceState& state, double t,
                                          const std::vector<glm::dvec2>& points,
                                          const SampleOptions& options = {}) {
  std::vector<SurfaceSample> samples(points.size());
  state.addTo(points, t, samples, options);
  return samples;
}

inline std::vector<double> heights(const DisturbanceState& state, double t,
                                   const std::vector<glm::dvec2>& points) {
  std::vector<double> result;
  for (const auto& sample : sampled(state, t, points)) result.push_back(sample.height);
  return result;
}

inline double largestOf(const std::vector<double>& values) {
  double largest = 0.0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  return largest;
}

inline double largestDifference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

/// Sails from 0 to `end` in steps of `dt`, heard all the way.
inline std::uint32_t sail(WakeSystem& system, double end, double dt, double speed = 4.0) {
  const std::uint32_t vessel = system.addVessel(launch());
  for (int i = 0; i * dt <= end + 1e-9; ++i) {
    system.record(vessel, sailing(i * dt, speed));
    system.advance(i * dt, beside(speed * i * dt));
  }
  return vessel;
}

}  // namespace seaway::test
