#include "sim_bridge/commands/explain.h"

#include <spdlog/fmt/fmt.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>

#include "render/headless_context.h"
#include "render/technique_choice.h"
#include "sim_bridge/commands/options.h"
#include "sim_bridge/output/picture_file.h"
#include "sim_bridge/output/progress.h"
#include "sim_bridge/scene/scene_loader.h"
#include "sim_bridge/scene_view.h"

namespace seaway::bridge {
namespace {

const char* unitOf(Effect effect) {
  switch (effect) {
    case Effect::waves:
    case Effect::vesselMotion:
    case Effect::hullLoads:
    case Effect::wake:
    case Effect::trail:
    case Effect::oil:
    case Effect::splash:
    case Effect::ripples:
      return "step";
    default:
      return "frame";
  }
}

/// Windows of wakes step every 0.1 and 0.4 s at the least: 0.8 s show what they cost on average.
std::size_t stepsToMeasure(const Scene& scene) {
  return static_cast<std::size_t>(std::ceil(0.8 / scene.run.step));
}

/// What a scene's effects did, and how often the work behind their costs was done.
struct Account {
  std::vector<EffectReport> effects;
  std::vector<SceneCamera> cameras;  // a frame each
  std::size_t steps = 1;

  double cost(const EffectReport& effect) const {
    const bool perFrame = std::string_view(unitOf(effect.effect)) == "frame";
    const std::size_t times = perFrame ? std::max<std::size_t>(cameras.size(), 1) : steps;
    return effect.costMicroseconds / static_cast<double>(times);
  }
};

void writeTable(const Account& account, std::ostream& out) {
  out << fmt::format("{:<16} {:<5} {:>12} {:>19}  {}\n", "effect", "state", "memory", "cost",
                     "reason");
  for (const EffectReport& effect : account.effects) {
    const std::string cost =
        effect.costInside
            ? fmt::format("inside {}", effectName(*effect.costInside))
            : fmt::format("{:.1f} us/{}", account.cost(effect), unitOf(effect.effect));
    out << fmt::format("{:<16} {:<5} {:>10} B {:>19}  {}\n", effectName(effect.effect),
                       effectStateName(effect.state), effect.memoryBytes, cost, effect.reason);
  }
  out << fmt::format(
      "costs: wall time of one step, mean of {}{}; first-use set-up is not in them\n",
      account.steps,
      account.cameras.empty() ? ""
      : account.cameras.size() == 1
          ? fmt::format(" and of the second frame of camera '{}'", account.cameras.front().name)
          : fmt::format(" and of each camera's second frame, mean of {} cameras",
                        account.cameras.size()));
}

void writeJson(const Account& account, std::ostream& out) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const EffectReport& effect : account.effects) {
    list.push_back({{"name", effectName(effect.effect)},
                    {"state", effectStateName(effect.state)},
                    {"reason", effect.reason},
                    {"memory_bytes", effect.memoryBytes},
                    {"cost_us", account.cost(effect)},
                    {"cost_per", unitOf(effect.effect)}});
    if (effect.costInside) list.back()["cost_inside"] = effectName(*effect.costInside);
  }
  nlohmann::ordered_json cameras = nlohmann::ordered_json::array();
  for (const SceneCamera& camera : account.cameras) cameras.push_back(camera.name);
  out << nlohmann::ordered_json{{"frames", cameras.size()},
                                {"cameras", std::move(cameras)},
                                {"effects", std::move(list)}}
             .dump(2)
      << '\n';
}

/// Every camera draws twice: the first frame sets up what later ones find there.
void drawAll(const Scene& scene, const std::vector<SceneCamera>& cameras,
             const Simulation& simulation, const std::string& backend, EffectLedger& ledger) {
  if (cameras.empty()) return;
  requireMemoryForPicture(scene.run.size);
  const auto technique = render::makeTechnique({.grid = scene.accuracy.grid, .backend = backend});
  SceneView view(scene);
  Progress progress("frames", 2 * cameras.size());
  std::size_t drawn = 0;
  for (const SceneCamera& camera : cameras) {
    EffectLedger warmUp(scene.effects);
    for (EffectLedger* counted : {&warmUp, &ledger}) {
      technique->draw(view.view(simulation, camera, scene.run.size, *counted));
      progress.update(++drawn);
    }
  }
}

}  // namespace

int runExplain(const ExplainOptions& options, std::ostream& out) {
  render::requireBackend(options.backend);
  const Scene scene = loadScene(options.scene);
  const double time = requireTime(options.time);
  const std::vector<SceneCamera> cameras =
      options.camera.empty() ? scene.cameras : std::vector{findCamera(scene, options.camera)};
  const Sea sea = buildSea(scene);
  Simulation simulation = replayWithProgress(scene, sea, time);
  simulation.attend({.cameras = cameras, .places = {}});
  EffectLedger ledger(scene.effects);
  drawAll(scene, cameras, simulation, options.backend, ledger);
  simulation.step();
  const std::size_t steps = stepsToMeasure(scene);
  for (std::size_t i = 0; i < steps; ++i) simulation.step(&ledger);
  const Account account{ledger.report(), cameras, steps};
  (options.json ? writeJson : writeTable)(account, out);
  return 0;
}

void addExplainCommand(CLI::App& app, ChosenCommand& chosen) {
  auto* command = app.add_subcommand("explain", "Show which effects run, why, and what they cost");
  auto options = std::make_shared<ExplainOptions>();
  command->add_option("SCENE", options->scene, "scene file")->required();
  command->add_option("--time", options->time, "seconds since the scene's epoch >= 0 (default 0)");
  command->add_option("--camera", options->camera, "camera's name (default: all of the scene's)")
      ->check(mustBeNamed);
  addBackendOption(*command, options->backend);
  command->add_flag("--json", options->json, "machine-readable");
  command->footer(
      "Example:\n  seaway explain configs/scenes/canaveral.yaml --time 5 --camera chase");
  command->callback([=, &chosen] { chosen = [=] { return runExplain(*options, std::cout); }; });
}

}  // namespace seaway::bridge
