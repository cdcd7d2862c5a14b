#include "sim_bridge/commands/explain.h"

#include <spdlog/fmt/fmt.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <nlohmann/json.hpp>

#include "render/headless_context.h"
#include "sim_bridge/commands/options.h"
#include "sim_bridge/scene/scene_loader.h"
#include "sim_bridge/scene_view.h"

namespace seaway::bridge {
namespace {

const char* stateName(EffectState state) {
  switch (state) {
    case EffectState::on:
      return "on";
    case EffectState::idle:
      return "idle";
    case EffectState::off:
      return "off";
  }
  return "";
}

std::string_view nameOf(Effect effect) {
  return effectDescriptions()[static_cast<std::size_t>(effect)].name;
}

void writeTable(const std::vector<EffectReport>& effects, std::ostream& out) {
  out << fmt::format("{:<16} {:<5} {:>12} {:>12}  {}\n", "effect", "state", "memory", "cost",
                     "reason");
  for (const EffectReport& effect : effects) {
    out << fmt::format("{:<16} {:<5} {:>10} B {:>9.1f} us  {}\n", nameOf(effect.effect),
                       stateName(effect.state), effect.memoryBytes, effect.costMicroseconds,
                       effect.reason);
  }
}

void writeJson(const std::vector<EffectReport>& effects, std::ostream& out) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const EffectReport& effect : effects) {
    list.push_back({{"name", nameOf(effect.effect)},
                    {"state", stateName(effect.state)},
                    {"reason", effect.reason},
                    {"memory_bytes", effect.memoryBytes},
                    {"cost_us", effect.costMicroseconds}});
  }
  out << nlohmann::ordered_json{{"effects", std::move(list)}}.dump(2) << '\n';
}

void drawAll(const Scene& scene, const Simulation& simulation, const std::string& backend,
             EffectLedger& ledger) {
  if (scene.cameras.empty()) return;
  const auto context = render::makeHeadlessContext(backend);
  const auto technique = render::makeProjectedGrid(*context, {.grid = scene.accuracy.grid});
  SceneView view(scene);
  for (const SceneCamera& camera : scene.cameras) {
    technique->draw(view.view(simulation, camera, scene.run.size, ledger));
  }
}

}  // namespace

int runExplain(const ExplainOptions& options, std::ostream& out) {
  render::requireBackend(options.backend);
  const Scene scene = loadScene(options.scene);
  const double time = requireTime(options.time);
  const Sea sea = buildSea(scene);
  Simulation simulation = Simulation::replayed(scene, sea, time);
  EffectLedger ledger(scene.effects);
  drawAll(scene, simulation, options.backend, ledger);
  simulation.step(&ledger);
  (options.json ? writeJson : writeTable)(ledger.report(), out);
  return 0;
}

void addExplainCommand(CLI::App& app, ChosenCommand& chosen) {
  auto* command = app.add_subcommand("explain", "Show which effects run, why, and what they cost");
  auto options = std::make_shared<ExplainOptions>();
  command->add_option("SCENE", options->scene, "scene file")->required();
  command->add_option("--time", options->time, "seconds since the scene's epoch (default 0)");
  addBackendOption(*command, options->backend);
  command->add_flag("--json", options->json, "machine-readable");
  command->footer("Example:\n  seaway explain configs/scenes/canaveral.yaml --time 5");
  command->callback([=, &chosen] { chosen = [=] { return runExplain(*options, std::cout); }; });
}

}  // namespace seaway::bridge
