#include "sim_bridge/cost/tuning.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <random>

#include "render/compare_frames.h"
#include "render/technique_choice.h"
#include "sim_bridge/cost/study.h"
#include "sim_bridge/scene_view.h"
#include "surface/disturbance/vessel_wake.h"
#include "surface/input_error.h"

namespace seaway::bridge {
namespace {

constexpr int repetitions = 5;

/// Rows of the reference's grid, closer than a tenth of a pixel.
constexpr glm::ivec2 finestGrid(4096, 4096);

std::vector<glm::dvec2> placesWithinTenKilometres() {
  std::mt19937_64 random(1);
  const auto part = [&] { return static_cast<double>(random() >> 11) * 0x1p-52 - 1.0; };
  std::vector<glm::dvec2> points(8192);
  for (glm::dvec2& point : points) point = 1e4 * glm::dvec2(part(), part());
  return points;
}

/// Octaves kept, from all of them down to none.
void tuneQueries(const Scene& scene, const Sea& sea, Tuning& tuning) {
  const std::optional<double> error = scene.accuracy.wanted.height, cost = scene.budget.query;
  if (!error && !cost) return;
  const WaveField& waves = sea.surface.waves();
  std::vector<Setting> settings;
  std::vector<double> tolerances;
  Scene tried = scene;
  const std::size_t count = waves.octaves().size();
  for (std::size_t left = 0; left <= count; ++left) {
    const std::size_t kept = count - left;
    tolerances.push_back(waves.leftOut(kept));
    tried.accuracy.motionTolerance = tolerances.back();
    const Setting measured = measureQueries(tried, sea, 0.0);
    settings.push_back({fmt::format("{} octaves", kept), waves.leftOut(kept), measured.cost});
  }
  const std::size_t best = chooseSetting(settings, error, cost, "heights", {"m", "ns a point"});
  tuning.tolerance = tolerances[best];
  tuning.foreseen.height = settings[best].error;
  tuning.foreseen.query = settings[best].cost;
}

/// Wall time of a frame, mean of the cameras.
double frameMilliseconds(const Scene& scene, const Simulation& simulation,
                         const std::string& backend) {
  SceneView view(scene);
  const auto technique = render::makeTechnique({.grid = scene.accuracy.grid, .backend = backend});
  render::Frame frame;
  const Timing timing = timeRepeated(
      [&] {
        for (const SceneCamera& camera : scene.cameras) {
          EffectLedger ledger(scene.effects);
          technique->drawInto(view.view(simulation, camera, scene.run.size, ledger), frame);
        }
      },
      repetitions);
  return 1e3 * timing.median / static_cast<double>(scene.cameras.size());
}

void tunePictures(const Scene& scene, const Sea& sea, const std::string& backend, Tuning& tuning) {
  const std::optional<double> error = scene.accuracy.wanted.position, cost = scene.budget.frame;
  if (!error && !cost) return;
  if (scene.cameras.empty()) {
    throw InputError("accuracy.pixel and budget.frame_ms need a camera in the scene");
  }
  // With the wakes and trails that a run's cameras see.
  Simulation simulation(scene, sea);
  simulation.attend({.cameras = scene.cameras, .places = {}});
  std::vector<Setting> settings;
  std::vector<glm::ivec2> grids;
  for (const int rows : {32, 64, 128, 256, 512, 1024}) {
    Scene tried = scene;
    tried.accuracy.grid = {std::max(2, rows / 2), rows};
    const double milliseconds = frameMilliseconds(tried, simulation, backend);
    const std::optional<double> place =
        error ? measurePosition(tried, simulation, backend) : std::optional<double>(0.0);
    if (!place) throw InputError("accuracy.pixel: the first camera sees no water");
    grids.push_back(tried.accuracy.grid);
    settings.push_back(
        {fmt::format("grid {}x{}", grids.back().x, grids.back().y), *place, milliseconds});
    // Finer grids only cost more.
    if (error && *place <= *error) break;
  }
  const auto finest = [&] {  // errors were not measured: the largest grid that is affordable
    std::vector<Setting> ranked = settings;
    for (std::size_t i = 0; i < ranked.size(); ++i) ranked[i].error = 1.0 / (1.0 + double(i));
    return ranked;
  };
  const std::size_t best =
      chooseSetting(error ? settings : finest(), error, cost, "pictures", {"px", "ms a frame"});
  tuning.grid = grids[best];
  tuning.foreseen.frame = settings[best].cost;
  Scene chosen = scene;
  chosen.accuracy.grid = grids[best];
  tuning.foreseen.position =
      error ? std::optional(settings[best].error) : measurePosition(chosen, simulation, backend);
}

/// Wall time of a step, over as many as wakes need to show what they cost on average.
double stepMicroseconds(const Scene& scene, const Sea& sea) {
  Simulation start(scene, sea);
  if (scene.run.framesPerSecond > 0.0) start.attend({.cameras = scene.cameras, .places = {}});
  start.step();
  const int steps = std::max(1, static_cast<int>(std::ceil(0.8 / scene.run.step)));
  Simulation simulation = start;
  const Timing timing = timeRepeated(
      [&] {
        for (int i = 0; i < steps; ++i) simulation.step();
      },
      repetitions);
  return 1e6 * timing.median / steps;
}

void tuneSteps(const Scene& scene, const Sea& sea, Tuning& tuning) {
  if (!scene.budget.step) return;
  std::vector<Setting> settings;
  std::vector<double> cells;
  double length = 0.0;
  for (const SceneVessel& vessel : scene.vessels) {
    length = std::max(length, vessel.model.hull.length);
  }
  const double standard = standardCascade(length, scene.sea.depth).front().window.cellSize;
  for (const double scale : {0.5, 1.0, 2.0, 4.0, 8.0}) {
    Scene tried = scene;
    tried.accuracy.wakes.cell = scale * standard;
    if (tuning.tolerance) tried.accuracy.motionTolerance = *tuning.tolerance;
    cells.push_back(tried.accuracy.wakes.cell);
    settings.push_back({fmt::format("wakes' cells of {:g} m", cells.back()), cells.back(),
                        stepMicroseconds(tried, sea)});
  }
  const std::size_t best =
      chooseSetting(settings, std::nullopt, scene.budget.step, "steps", {"m a cell", "us a step"});
  tuning.wakeCell = cells[best];
  tuning.foreseen.step = settings[best].cost;
}

}  // namespace

std::size_t chooseSetting(const std::vector<Setting>& settings, std::optional<double> error,
                          std::optional<double> cost, const std::string& what,
                          const std::pair<std::string, std::string>& units) {
  const auto told = [&](const Setting& setting) {
    return fmt::format("{}: {:.3g} {} at {:.4g} {}", setting.name, setting.error, units.first,
                       setting.cost, units.second);
  };
  std::optional<std::size_t> best;
  const auto better = [&](const Setting& a, const Setting& b) {
    return error ? a.cost < b.cost : a.error < b.error;
  };
  for (std::size_t i = 0; i < settings.size(); ++i) {
    if (error && settings[i].error > *error) continue;
    if (cost && settings[i].cost > *cost) continue;
    if (!best || better(settings[i], settings[*best])) best = i;
  }
  if (best) return *best;
  const auto exact =
      std::min_element(settings.begin(), settings.end(),
                       [](const Setting& a, const Setting& b) { return a.error < b.error; });
  const auto cheap =
      std::min_element(settings.begin(), settings.end(),
                       [](const Setting& a, const Setting& b) { return a.cost < b.cost; });
  throw InputError("no setting of " + what + " does what is asked on this machine; most exact: " +
                   told(*exact) + "; cheapest: " + told(*cheap));
}

Setting measureQueries(const Scene& scene, const Sea& sea, double t) {
  static const std::vector<glm::dvec2> points = placesWithinTenKilometres();
  const WaterSurface water{sea.surface.waves()};
  std::vector<SurfaceSample> truth(points.size()), samples(points.size());
  const SampleOptions options{.tolerance = scene.accuracy.motionTolerance};
  water.sample(points, t, truth);
  const Timing timing =
      timeRepeated([&] { water.sample(points, t, samples, options); }, repetitions);
  double squares = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    squares += std::pow(samples[i].height - truth[i].height, 2);
  }
  const auto count = static_cast<double>(points.size());
  return {"", std::sqrt(squares / count), 1e9 * timing.median / count};
}

std::optional<double> measurePosition(const Scene& scene, const Simulation& simulation,
                                      const std::string& backend) {
  if (scene.cameras.empty()) return std::nullopt;
  SceneView view(scene);
  EffectLedger ledger(scene.effects);
  // A smaller picture of the same view, for rays are slow: what is off by an angle is off by as
  // much more pixels as the picture has.
  const double part = std::min(1.0, 480.0 / scene.run.size.x);
  const glm::ivec2 size = glm::max(glm::ivec2(glm::dvec2(scene.run.size) * part), glm::ivec2(1));
  render::View seen = view.view(simulation, scene.cameras[0], size, ledger);
  seen.wantsNormals = true;
  const render::Frame drawn =
      render::makeTechnique({.grid = scene.accuracy.grid, .backend = backend})->draw(seen);
  const render::Frame rays = render::makeReference({.grid = finestGrid})->draw(seen);
  const double rms = render::compareFrames(seen.camera, drawn, rays).positionRms;
  const double scale = static_cast<double>(scene.run.size.x) / size.x;
  return std::isfinite(rms) ? std::optional(rms * scale) : std::nullopt;
}

Tuning tune(const Scene& scene, const Sea& sea, const std::string& backend,
            const std::function<void(std::size_t done)>& progress) {
  if (!scene.accuracy.wanted.any() && !scene.budget.any()) {
    throw InputError(
        "nothing is asked for: give accuracy.height_m, accuracy.pixel, budget.query_ns, "
        "budget.frame_ms or budget.step_us in the scene or as options");
  }
  Tuning tuning;
  const auto done = [&](std::size_t parts) {
    if (progress) progress(parts);
  };
  tuneQueries(scene, sea, tuning);
  done(1);
  tunePictures(scene, sea, backend, tuning);
  done(2);
  tuneSteps(scene, sea, tuning);
  done(3);
  return tuning;
}

}  // namespace seaway::bridge
