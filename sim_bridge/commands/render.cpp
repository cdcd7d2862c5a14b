#include "sim_bridge/commands/render.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <nlohmann/json.hpp>

#include "render/headless_context.h"
#include "sim_bridge/commands/options.h"
#include "sim_bridge/output/picture_file.h"
#include "sim_bridge/output/progress.h"
#include "sim_bridge/output/stopwatch.h"
#include "sim_bridge/scene/scene_loader.h"
#include "sim_bridge/scene_view.h"

namespace seaway::bridge {
namespace {

void report(const RenderOptions& options, const SceneCamera& camera, const render::Frame& frame,
            double drawMs, std::ostream& out) {
  const render::FrameStats& stats = frame.stats;
  if (!options.json) {
    out << options.out << ": camera '" << camera.name << "' at " << options.time << " s, "
        << frame.colour.size.x << "x" << frame.colour.size.y << ", drawn in " << drawMs << " ms by "
        << stats.technique << " on " << stats.renderer << '\n';
    return;
  }
  nlohmann::ordered_json passes = nlohmann::ordered_json::object();
  for (const auto& [name, milliseconds] : stats.passesMs) passes[name] = milliseconds;
  const nlohmann::ordered_json result{{"out", options.out},
                                      {"camera", camera.name},
                                      {"time_s", options.time},
                                      {"size", {frame.colour.size.x, frame.colour.size.y}},
                                      {"technique", stats.technique},
                                      {"backend", stats.backend},
                                      {"renderer", stats.renderer},
                                      {"draw_ms", drawMs},
                                      {"passes_ms", passes},
                                      {"vertices", stats.vertices},
                                      {"vertex_efficiency", stats.vertexEfficiency},
                                      {"bound_redraws", stats.boundRedraws}};
  out << result.dump(2) << '\n';
}

}  // namespace

int runRender(const RenderOptions& options, std::ostream& out) {
  render::requireBackend(options.backend);
  const Scene scene = loadScene(options.scene);
  const double time = requireTime(options.time);
  const SceneCamera& camera = findCamera(scene, options.camera);
  const glm::ivec2 size = options.size.empty() ? scene.run.size : parseSize(options.size);
  requireWritablePicture(options.out);
  requireMemoryForPicture(size);
  const Sea sea = buildSea(scene);
  const Simulation simulation = replayWithProgress(scene, sea, time);
  const auto context = render::makeHeadlessContext(options.backend);
  const auto technique = render::makeProjectedGrid(*context, {.grid = scene.accuracy.grid});
  SceneView view(scene);
  EffectLedger ledger(scene.effects);
  const Stopwatch watch;
  const render::Frame frame = technique->draw(view.view(simulation, camera, size, ledger));
  const double drawMs = watch.milliseconds();
  writePicture(options.out, frame.colour);
  report(options, camera, frame, drawMs, out);
  return 0;
}

void addRenderCommand(CLI::App& app, ChosenCommand& chosen) {
  auto* command = app.add_subcommand("render", "Draw one picture of a scene");
  auto options = std::make_shared<RenderOptions>();
  command->add_option("SCENE", options->scene, "scene file")->required();
  command->add_option("--time", options->time, "seconds since the scene's epoch, >= 0")->required();
  command->add_option("--camera", options->camera, "camera's name (default: the scene's first)");
  command->add_option("--size", options->size, "WIDTHxHEIGHT in pixels (default: the scene's)");
  command->add_option("--out", options->out, "PNG file to write")->required()->check(mustBeNamed);
  addBackendOption(*command, options->backend);
  command->add_flag("--json", options->json, "machine-readable");
  command->footer(
      "Example:\n  seaway render configs/scenes/canaveral.yaml --time 5 --camera chase --out "
      "launch.png");
  command->callback([=, &chosen] { chosen = [=] { return runRender(*options, std::cout); }; });
}

}  // namespace seaway::bridge
