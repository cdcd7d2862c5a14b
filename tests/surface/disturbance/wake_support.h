#pragma once

#include <cmath>
#include <functional>
#include <memory>
#include <vector>

#include "surface/disturbance/disturbance_state.h"
#include "surface/disturbance/hull_footprint.h"
#include "surface/disturbance/wake_window.h"

namespace seaway::test {

inline WakeWindow makeWindow(const WakeWindowSettings& settings, const HullFootprint& hull,
                             double dt) {
  return WakeWindow(std::make_shared<const WakeTables>(settings, dt),
                    std::make_shared<const FootprintTable>(
                        hull, settings.depth, WakeWindow::largestWaveNumber(settings)));
}

/// Settings of a window of `cells` cells and half as many modes, whose shortest waves are 2 to 4
/// times what the modes carry.
inline WakeWindowSettings windowOf(double size, int cells, int modes) {
  WakeWindowSettings settings;
  settings.cells = cells;
  settings.modes = modes;
  settings.cellSize = size / cells;
  settings.band.shortNone = settings.wavelengthLimit();
  settings.band.shortAll = 2.0 * settings.band.shortNone;
  return settings;
}

/// Sails a hull along `course` from t = 0 to steps · dt; the window's centre lies `astern` m
/// behind.
inline void sail(WakeWindow& window, double dt, int steps,
                 const std::function<HullPlace(double)>& course, double astern = 0.0,
                 int stepsPerBorder = 4) {
  window.settle(course(0.0));
  for (int i = 0; i < steps; ++i) {
    window.step(dt, course(i * dt), course((i + 1) * dt));
    if ((i + 1) % stepsPerBorder != 0) continue;
    const HullPlace now = course((i + 1) * dt);
    const glm::dvec2 ahead(std::cos(now.heading), std::sin(now.heading));
    window.absorb(now.position - astern * ahead, stepsPerBorder * dt);
  }
}

inline std::function<HullPlace(double)> straight(double speed, double heading = 0.0) {
  return [=](double t) {
    return HullPlace{speed * t * glm::dvec2(std::cos(heading), std::sin(heading)), heading, 1.0};
  };
}

/// The window's surface as it is, in an interval of no length to speak of.
inline DisturbanceState stillState(const WakeWindow& window, glm::dvec2 centre,
                                   bool withPotential = false) {
  const auto grid = std::make_shared<WakeGrid>(window.settings().cells, withPotential);
  window.draw(*grid);
  VesselWaves waves{1, {{grid, grid, 0.0, 1.0, window.settings().cellSize, centre}}, 0.0};
  return DisturbanceState({waves}, {});
}

inline std::vector<SurfaceSample> samplesOf(const DisturbanceState& state,
                                            const std::vector<glm::dvec2>& points, double t = 0.0,
                                            const SampleOptions& options = {}) {
  std::vector<SurfaceSample> samples(points.size());
  if (options.orbitalVelocity) {
    for (SurfaceSample& sample : samples) sample.orbitalVelocity = glm::dvec3(0.0);
  }
  state.addTo(points, t, samples, options);
  return samples;
}

}  // namespace seaway::test
