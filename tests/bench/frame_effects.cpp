#include <sys/resource.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "render/technique_choice.h"
#include "sim_bridge/scene/scene_loader.h"
#include "sim_bridge/scene_view.h"

/// What each effect costs a frame, by technique: milliseconds that a frame takes longer with it
/// than with it switched off.
///
///   frame_effects [--backend egl:0] [--size 1280x720] [--repeats 9] [--column software]
///   [SCENE:CAMERA:TIME ...]
///
/// Two techniques of each kind draw by turns, one with all that the scene calls for, one without
/// the effect; the table has the medians of their frames' difference, and of whole frames. A
/// negative number is noise, or an effect without which more is drawn. The sea's wakes and layers
/// belong to the simulation and stay.
///
///   frame_effects --frames [--threads 2] [--size 1280x720] [--repeats 25] [SCENE:CAMERA:TIME ...]
///
/// instead has a row a view, of the gallery's unless any are named, drawn in software: medians of
/// the frame's wall time, of the processor time that it takes on all threads together, which other
/// programs disturb less, and of the passes' wall times.
namespace seaway::bench {
namespace {

using namespace seaway::bridge;

struct Options {
  std::string backend = "osmesa";
  glm::ivec2 size{1280, 720};
  int repeats = 9;
  std::string column;  // this one alone; empty: all
  bool frames = false;
  int threads = 0;  // 0: as many as there are cores
  std::vector<std::string> views;
};

struct Column {
  std::string name;
  render::TechniqueChoice choice;
};

std::vector<Column> columnsFor(const std::string& backend, glm::ivec2 grid) {
  std::vector<Column> columns;
  const auto add = [&](const char* name, const char* technique, const char* variant) {
    columns.push_back(
        {name, {.technique = technique, .variant = variant, .grid = grid, .backend = backend}});
  };
  if (backend == "osmesa") {
    add("software", "projected_grid", "software");
    add("radial_grid", "radial_grid", "automatic");
    add("post_process", "post_process", "automatic");
  }
  add("marched", "projected_grid", "marched");
  add("gpu", "projected_grid", "gpu");
  add("cpu_vertices", "projected_grid", "cpu_vertices");
  return columns;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// A scene with its sea sailed up to a moment.
struct Stage {
  Scene scene;
  Sea sea;
  SceneCamera camera;
  Simulation simulation;
  SceneView view;

  Stage(const std::string& path, const std::string& cameraName, double time)
      : scene(loadScene(path)),
        sea(buildSea(scene)),
        camera(findCamera(scene, cameraName)),
        simulation(Simulation::replayed(scene, sea, time)),
        view(scene) {
    simulation.attend({.cameras = {camera}, .places = {}});
  }

  double drawMs(render::RenderTechnique& technique, const EffectSettings& settings, glm::ivec2 size,
                render::Frame& frame, std::vector<EffectReport>* effects = nullptr) {
    EffectLedger ledger(settings);
    const render::View seen = view.view(simulation, camera, size, ledger);
    const auto begin = std::chrono::steady_clock::now();
    technique.drawInto(seen, frame);
    const std::chrono::duration<double, std::milli> taken =
        std::chrono::steady_clock::now() - begin;
    if (effects) *effects = ledger.report();
    return taken.count();
  }
};

/// Frame and each effect that is on, ms.
struct Costs {
  double frame = 0.0;
  std::map<std::string, double> effects;
};

Costs measure(Stage& stage, const Column& column, const Options& options) {
  const auto whole = render::makeTechnique(column.choice);
  render::Frame frame;
  std::vector<EffectReport> reports;
  for (int i = 0; i < 2; ++i) {
    stage.drawMs(*whole, stage.scene.effects, options.size, frame, &reports);
  }
  Costs costs;
  std::vector<double> frames;
  for (const EffectReport& report : reports) {
    if (report.state != EffectState::on) continue;
    EffectSettings without = stage.scene.effects;
    without[static_cast<std::size_t>(report.effect)] = EffectSetting::off;
    const auto less = render::makeTechnique(column.choice);
    for (int i = 0; i < 2; ++i) stage.drawMs(*less, without, options.size, frame);
    std::vector<double> differences;
    for (int i = 0; i < options.repeats; ++i) {
      const double with = stage.drawMs(*whole, stage.scene.effects, options.size, frame);
      differences.push_back(with - stage.drawMs(*less, without, options.size, frame));
      frames.push_back(with);
    }
    costs.effects[std::string(effectName(report.effect))] = median(differences);
  }
  costs.frame = frames.empty() ? 0.0 : median(frames);
  return costs;
}

double processorMs() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto ms = [](const timeval& t) { return 1e3 * t.tv_sec + 1e-3 * t.tv_usec; };
  return ms(usage.ru_utime) + ms(usage.ru_stime);
}

/// A view's row of `--frames`.
void printFrame(Stage& stage, const std::string& view, const Options& options) {
  const auto technique = render::makeTechnique(
      {.technique = "projected_grid", .variant = "software", .grid = stage.scene.accuracy.grid});
  render::Frame frame;
  std::vector<double> walls, processor;
  std::vector<std::pair<std::string, std::vector<double>>> passes;
  for (int i = -2; i < options.repeats; ++i) {  // two to set up what stays
    const double before = processorMs();
    const double wall = stage.drawMs(*technique, stage.scene.effects, options.size, frame);
    if (i < 0) continue;
    processor.push_back(processorMs() - before);
    walls.push_back(wall);
    const auto& taken = frame.stats.passesMs;
    passes.resize(taken.size());
    for (std::size_t k = 0; k < taken.size(); ++k) {
      passes[k].first = taken[k].first;
      passes[k].second.push_back(taken[k].second);
    }
  }
  std::printf("%-44s %8.1f %10.1f  ", view.c_str(), median(walls), median(processor));
  for (const auto& [name, ms] : passes) std::printf(" %s %.1f", name.c_str(), median(ms));
  std::printf("\n");
  std::fflush(stdout);
}

void printTable(const std::string& view, const std::vector<Column>& columns,
                const std::vector<Costs>& costs) {
  std::printf("\n%s, ms\n%-14s", view.c_str(), "");
  for (const Column& column : columns) std::printf(" %12s", column.name.c_str());
  std::printf("\n%-14s", "whole frame");
  for (const Costs& cost : costs) std::printf(" %12.2f", cost.frame);
  std::printf("\n");
  std::map<std::string, int> names;
  for (const Costs& cost : costs) {
    for (const auto& [name, ms] : cost.effects) names[name] = 1;
  }
  for (const auto& [name, unused] : names) {
    std::printf("%-14s", name.c_str());
    for (const Costs& cost : costs) {
      const auto at = cost.effects.find(name);
      if (at == cost.effects.end()) {
        std::printf(" %12s", "-");
      } else {
        std::printf(" %12.2f", at->second);
      }
    }
    std::printf("\n");
  }
  std::fflush(stdout);
}

void run(const Options& options) {
  if (options.frames) std::printf("%-44s %8s %10s   passes, ms\n", "view", "wall", "processor");
  for (const std::string& text : options.views) {
    std::istringstream parts(text);
    std::string path, camera, time;
    std::getline(parts, path, ':');
    std::getline(parts, camera, ':');
    std::getline(parts, time);
    Stage stage(path, camera, std::atof(time.c_str()));
    if (options.frames) {
      printFrame(stage, text, options);
      continue;
    }
    std::vector<Column> columns = columnsFor(options.backend, stage.scene.accuracy.grid);
    if (!options.column.empty()) {
      std::erase_if(columns, [&](const Column& c) { return c.name != options.column; });
    }
    std::vector<Costs> costs;
    for (const Column& column : columns) costs.push_back(measure(stage, column, options));
    printTable(text + ", " + std::to_string(options.size.x) + "x" + std::to_string(options.size.y),
               columns, costs);
  }
}

}  // namespace
}  // namespace seaway::bench

int main(int argc, char** argv) {
  seaway::bench::Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const bool hasValue = i + 1 < argc;
    if (hasValue && word == "--backend") {
      options.backend = argv[++i];
    } else if (hasValue && word == "--repeats") {
      options.repeats = std::max(1, std::atoi(argv[++i]));
    } else if (word == "--frames") {
      options.frames = true;
    } else if (hasValue && word == "--threads") {
      options.threads = std::max(0, std::atoi(argv[++i]));
    } else if (hasValue && word == "--column") {
      options.column = argv[++i];
    } else if (hasValue && word == "--size") {
      if (std::sscanf(argv[++i], "%dx%d", &options.size.x, &options.size.y) != 2) return 2;
    } else {
      options.views.push_back(word);
    }
  }
  if (options.views.empty() && options.frames) {
    options.views = {
        "configs/scenes/dawn.yaml:shore:4",          "configs/scenes/calm.yaml:quay:10",
        "configs/scenes/canaveral.yaml:chase:20",    "configs/scenes/canaveral.yaml:bow:20",
        "configs/scenes/storm.yaml:chase:12",        "configs/scenes/harbour.yaml:quay:5",
        "configs/scenes/harbour.yaml:pier:4",        "configs/scenes/island.yaml:boat:4",
        "configs/scenes/island.yaml:reef:4",         "configs/scenes/under_water.yaml:diver:4",
        "configs/scenes/under_water.yaml:swimmer:4", "configs/scenes/night.yaml:quay:8",
        "configs/scenes/crater_lake.yaml:shore:20",  "configs/scenes/crater_lake.yaml:rim:20",
        "configs/scenes/crossing_wakes.yaml:mast:30"};
  } else if (options.views.empty()) {
    options.views = {"configs/scenes/canaveral.yaml:chase:20", "configs/scenes/harbour.yaml:quay:5",
                     "configs/scenes/storm.yaml:chase:12",
                     "configs/scenes/crater_lake.yaml:shore:20"};
  }
  const tbb::global_control limit(
      tbb::global_control::max_allowed_parallelism,
      options.threads > 0
          ? options.threads
          : tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
  try {
    seaway::bench::run(options);
  } catch (const std::exception& fault) {
    std::fprintf(stderr, "%s\n", fault.what());
    return 2;
  }
  return 0;
}
