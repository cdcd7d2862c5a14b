#include <algorithm>
#include <cmath>

#include "sim_bridge/cost/calibration.h"
#include "sim_bridge/cost/study.h"
#include "sim_bridge/output/number_text.h"
#include "sim_bridge/scene/scene.h"
#include "sim_bridge/vessel/wake_footprint.h"
#include "surface/disturbance/steady_wake.h"
#include "surface/disturbance/wake_system.h"

namespace seaway::bridge {
namespace {

/// One setting of the windows of a vessel that has sailed straight for a minute.
struct Windows {
  double cell, window, step;  // m, m, s; step: of the finest window
  std::string setting;
  double dial = 0.0;  // what is varied
};

class Sailed {
 public:
  Sailed(const SceneVessel& vessel, double depth, const Windows& windows)
      : speed_(vessel.speed), system_(settingsOf(vessel, depth, windows)) {
    handle_ = system_.addVessel(wakeFootprint(vessel.model));
    for (int i = -600; i <= 0; ++i) record(0.1 * i);
    advance();
  }
  /// 0.1 s more.
  void sailOn() {
    record(time_ += 0.1);
    advance();
  }
  double time() const { return time_; }
  std::vector<double> heights(const std::vector<glm::dvec2>& fromVessel) const {
    std::vector<SurfaceSample> samples(fromVessel.size());
    std::vector<glm::dvec2> points = fromVessel;
    for (glm::dvec2& point : points) point.x += speed_ * time_;
    system_.latest()->addTo(points, time_, samples, {.derivatives = false});
    std::vector<double> heights;
    for (const SurfaceSample& sample : samples) heights.push_back(sample.height);
    return heights;
  }

 private:
  static WakeSystemSettings settingsOf(const SceneVessel& vessel, double depth,
                                       const Windows& windows) {
    WakeSystemSettings settings;
    settings.depth = depth;
    settings.cascade = cascadeOf(vessel.model.hull.length, depth, windows.cell, windows.window);
    const double longer = windows.step / settings.cascade.front().step;
    for (WakeLevel& level : settings.cascade) level.step *= longer;
    return settings;
  }
  void record(double t) { system_.record(handle_, {t, {speed_ * t, 0.0}, 0.0, 1.0}); }
  void advance() {
    system_.advance(time_, std::vector<WakeListener>{{{speed_ * time_, 0.0}, 1.0, 0}});
  }
  double speed_, time_ = 0.0;
  WakeSystem system_;
  std::uint32_t handle_ = 0;
};

/// Astern of the vessel and beside its hull, where even small windows are whole.
std::vector<glm::dvec2> placesAround(const BoxHull& hull, double scale) {
  std::vector<glm::dvec2> places;
  for (int i = 0; i < 24; ++i) {
    for (int j = -17; j <= 17; ++j) {
      const glm::dvec2 place(-scale * (7.0 + i), scale * j);
      if (std::abs(place.y) > hull.beam) places.push_back(place);
    }
  }
  return places;
}

double rmsDifference(const std::vector<double>& a, const std::vector<double>& b) {
  double square = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) square += std::pow(a[i] - b[i], 2);
  return std::sqrt(square / static_cast<double>(a.size()));
}

/// rms error in % of the largest height, and what 0.1 s of sailing costs.
CostPoint measured(const Windows& windows, const SceneVessel& vessel, double depth,
                   const std::vector<glm::dvec2>& places, const std::vector<double>& truth,
                   int repetitions) {
  Sailed sailed(vessel, depth, windows);
  const std::vector<double> heights = sailed.heights(places);
  double largest = 0.0;
  for (const double height : truth) largest = std::max(largest, std::abs(height));
  // Borders and coarse windows work at their own intervals: 1.6 s hold some of each.
  const Timing timing = timeRepeated(
      [&] {
        for (int i = 0; i < 16; ++i) sailed.sailOn();
      },
      repetitions);
  return {windows.setting, 100.0 * rmsDifference(heights, truth) / largest,
          1e6 / 16.0 * timing.median, 1e6 / 16.0 * timing.spread, windows.dial};
}

const SceneVessel* vesselUnderWay(const Scene& scene) {
  const auto found = std::find_if(scene.vessels.begin(), scene.vessels.end(),
                                  [](const SceneVessel& vessel) { return vessel.speed != 0.0; });
  return found == scene.vessels.end() ? nullptr : &*found;
}

}  // namespace

std::vector<CellCheck> checkWakeCells(const Scene& scene) {
  const SceneVessel* vessel = vesselUnderWay(scene);
  if (!vessel) return {};
  const double depth = scene.sea.depth;
  const auto standard = standardCascade(vessel->model.hull.length, depth);
  const double cell = standard.front().window.cellSize, window = standard.back().window.size();
  const auto places = placesAround(vessel->model.hull, cell / 0.5);
  if (places.empty()) return {};  // too wide a hull
  const auto heightsOf = [&](double size) {
    return Sailed(*vessel, depth, {size, window, standard.front().step, ""}).heights(places);
  };
  const std::vector<double> finest = heightsOf(0.5 * cell);
  const double longest = transverseWavelengthTheory(std::abs(vessel->speed), depth);  // NaN: any
  std::vector<CellCheck> checks;
  std::vector<double> coarser = heightsOf(8.0 * cell);
  for (const double size : {4.0 * cell, 2.0 * cell}) {
    const std::vector<double> heights = heightsOf(size);
    if (!(longest < 8.0 * size))
      checks.push_back({size, rmsDifference(heights, coarser), rmsDifference(heights, finest)});
    coarser = heights;
  }
  return checks;
}

std::vector<Study> studyWakes(const Scene& scene, const StudyOptions& options) {
  const SceneVessel* underWay = vesselUnderWay(scene);
  if (!underWay) return {};
  const SceneVessel& vessel = *underWay;
  const double depth = scene.sea.depth;
  const auto standard = standardCascade(vessel.model.hull.length, depth);
  const double cell = standard.front().window.cellSize, step = standard.front().step;
  const double scale = cell / 0.5, window = standard.back().window.size();
  const std::vector<glm::dvec2> places = placesAround(vessel.model.hull, scale);
  if (places.empty()) return {};  // too wide a hull
  // Each dial against its own finest setting, the others as they are.
  const auto study = [&](std::string name, const std::string& dial, const Windows& finest,
                         std::vector<Windows> settings) {
    const std::vector<double> truth = Sailed(vessel, depth, finest).heights(places);
    Study result{std::move(name),
                 dial + " of the wake of " + vessel.name + "; truth: " + finest.setting,
                 "% of height",
                 "us/0.1 s",
                 {}};
    for (const Windows& windows : settings) {
      result.points.push_back(
          measured(windows, vessel, depth, places, truth, options.quick ? 3 : 9));
    }
    return result;
  };
  const auto label = [](const char* dial, double value, const char* unit) {
    return std::string(dial) + " " + numberText(value) + " " + unit;
  };
  std::vector<Windows> cells, steps, windows;
  for (const double part : {4.0, 2.0, 1.0}) {
    cells.push_back({part * cell, window, step, label("cell", part * cell, "m"), part * cell});
  }
  for (const double part : {8.0, 4.0, 2.0, 1.0}) {
    steps.push_back({cell, window, part * step, label("step", part * step, "s"), part * step});
  }
  for (const double part : {0.0625, 0.125, 0.25, 1.0}) {
    windows.push_back(
        {cell, part * window, step, label("window", part * window, "m"), part * window});
  }
  return {study("wake_cell", "cell size",
                {0.5 * cell, window, step, label("cells of", 0.5 * cell, "m")}, cells),
          study("wake_step", "step",
                {cell, window, 0.25 * step, label("steps of", 0.25 * step, "s")}, steps),
          study("wake_window", "window",
                {cell, 2.0 * window, step, label("a window of", 2.0 * window, "m")}, windows)};
}

}  // namespace seaway::bridge
