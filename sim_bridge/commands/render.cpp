#include "sim_bridge/commands/render.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <nlohmann/json.hpp>

#include "render/compare_frames.h"
#include "render/headless_context.h"
#include "render/technique_choice.h"
#include "sim_bridge/commands/free_camera.h"
#include "sim_bridge/commands/options.h"
#include "sim_bridge/output/picture_file.h"
#include "sim_bridge/output/progress.h"
#include "sim_bridge/output/stopwatch.h"
#include "sim_bridge/scene/scene_loader.h"
#include "sim_bridge/scene_view.h"
#include "surface/input_error.h"

namespace seaway::bridge {
namespace {

/// What was drawn and what is said of it.
struct Drawn {
  render::Frame frame;
  double drawMs = 0.0;
  std::optional<render::FrameComparison> comparison;
};

nlohmann::ordered_json asJson(const render::FrameComparison& comparison) {
  return {{"depth_median_m", comparison.depthMedian},
          {"position_rms_px", comparison.positionRms},
          {"position_p99_px", comparison.positionPercentile99},
          {"compared_px", comparison.compared},
          {"missing_px", comparison.missing},
          {"extra_px", comparison.extra},
          {"far_from_silhouettes_px", comparison.misplaced}};
}

void report(const RenderOptions& options, const SceneCamera& camera, const Drawn& drawn,
            std::ostream& out) {
  const render::FrameStats& stats = drawn.frame.stats;
  const glm::ivec2 size = drawn.frame.colour.size;
  if (!options.json && !options.stats) {
    out << options.out << ": camera '" << camera.name << "' at " << options.time << " s, "
        << size.x << "x" << size.y << ", drawn in " << drawn.drawMs << " ms by "
        << stats.technique << (stats.variant.empty() ? "" : "/" + stats.variant) << " on "
        << stats.renderer << '\n';
    if (drawn.comparison) out << asJson(*drawn.comparison).dump(2) << '\n';
    return;
  }
  nlohmann::ordered_json passes = nlohmann::ordered_json::object();
  for (const auto& [name, milliseconds] : stats.passesMs) passes[name] = milliseconds;
  nlohmann::ordered_json result{{"out", options.out},
                                {"camera", camera.name},
                                {"time_s", options.time},
                                {"size", {size.x, size.y}},
                                {"technique", stats.technique},
                                {"variant", stats.variant},
                                {"backend", stats.backend},
                                {"renderer", stats.renderer},
                                {"draw_ms", drawn.drawMs},
                                {"passes_ms", passes},
                                {"vertices", stats.vertices},
                                {"vertex_efficiency", stats.vertexEfficiency},
                                {"bound_redraws", stats.boundRedraws}};
  if (drawn.comparison) result["compare"] = asJson(*drawn.comparison);
  out << result.dump(2) << '\n';
}

/// What the command line asks for, checked before any work.
struct Request {
  Scene scene;
  SceneCamera camera;
  glm::ivec2 size;
  render::TechniqueChoice choice;
};

Request requestFrom(const RenderOptions& options) {
  render::requireBackend(options.backend);
  Request request{loadScene(options.scene), {}, {}, {}};
  requireTime(options.time);
  request.camera = options.from.empty() ? findCamera(request.scene, options.camera)
                                        : freeCamera(options);
  if (options.from.empty()) refuseFreeCameraOptions(options);
  request.size = options.size.empty() ? request.scene.run.size : parseSize(options.size);
  request.choice = {.technique = options.technique,
                    .variant = options.variant,
                    .grid = options.grid.empty() ? request.scene.accuracy.grid
                                                 : parseGrid(options.grid),
                    .backend = options.backend};
  if (!options.compare.empty() && options.compare != "reference") {
    throw InputError("--compare: '" + options.compare + "' is not allowed; must be: reference");
  }
  requireWritablePicture(options.out);
  for (const std::string* exr : {&options.depth, &options.normals}) {
    if (!exr->empty()) requireWritableExr(*exr);
  }
  requireMemoryForPicture(request.size);
  return request;
}

Drawn draw(const RenderOptions& options, const Request& request) {
  const auto technique = render::makeTechnique(request.choice);
  const Sea sea = buildSea(request.scene);
  Simulation simulation = replayWithProgress(request.scene, sea, options.time);
  simulation.attend({.cameras = {request.camera}, .places = {}});
  SceneView sceneView(request.scene);
  EffectLedger ledger(request.scene.effects);
  render::View view = sceneView.view(simulation, request.camera, request.size, ledger);
  view.wantsNormals = !options.normals.empty();
  Drawn drawn;
  if (options.stats) technique->drawInto(view, drawn.frame);  // sets up what stays
  const Stopwatch watch;
  technique->drawInto(view, drawn.frame);
  drawn.drawMs = watch.milliseconds();
  if (!options.compare.empty()) {
    view.wantsNormals = true;
    const auto reference = render::makeTechnique(
        {.technique = options.compare, .variant = "automatic", .grid = request.choice.grid});
    drawn.comparison =
        render::compareFrames(view.camera, drawn.frame, reference->draw(view));
  }
  return drawn;
}

void addCameraOptions(CLI::App& command, RenderOptions& options) {
  command.add_option("--camera", options.camera, "camera's name (default: the scene's first)");
  command.add_option("--from", options.from,
                     "LAT,LON,HEIGHT: a camera of your own, degrees and metres above still water");
  command.add_option("--yaw", options.yaw_deg, "degrees clockwise from true north, with --from");
  command.add_option("--pitch", options.pitch_deg, "degrees up, with --from");
  command.add_option("--roll", options.roll_deg, "degrees, right side down, with --from");
  command.add_option("--fov", options.fieldOfView_deg, "vertical degrees, with --from (60)");
  command.add_option("--size", options.size, "WIDTHxHEIGHT in pixels (default: the scene's)");
}

}  // namespace

int runRender(const RenderOptions& options, std::ostream& out) {
  const Request request = requestFrom(options);
  const Drawn drawn = draw(options, request);
  if (!options.depth.empty()) writeDepth(options.depth, drawn.frame);
  if (!options.normals.empty()) writeNormals(options.normals, drawn.frame);
  writePicture(options.out, drawn.frame.colour);
  report(options, request.camera, drawn, out);
  return 0;
}

void addRenderCommand(CLI::App& app, ChosenCommand& chosen) {
  auto* command = app.add_subcommand("render", "Draw one picture of a scene");
  auto options = std::make_shared<RenderOptions>();
  command->add_option("SCENE", options->scene, "scene file")->required();
  command->add_option("--time", options->time, "seconds since the scene's epoch, >= 0")->required();
  addCameraOptions(*command, *options);
  command->add_option("--out", options->out, "PNG file to write")->required()->check(mustBeNamed);
  command->add_option("--depth", options->depth, "EXR file of axial distances, m, +inf for sky")
      ->check(mustBeNamed);
  command->add_option("--normals", options->normals, "EXR file of unit normals, east north up")
      ->check(mustBeNamed);
  command->add_option("--technique", options->technique,
                      "projected_grid (default), radial_grid, post_process, naive_grid or reference");
  command->add_option("--variant", options->variant,
                      "of projected_grid: automatic, software, cpu_vertices, gpu, "
                      "cpu_vertices_gpu_normals or marched (default automatic: the fastest)");
  command->add_option("--grid", options->grid, "COLUMNSxROWS of vertices (default: the scene's)");
  command->add_option("--compare", options->compare,
                      "reference: say how far the picture is from a ray-cast of the same sea");
  addBackendOption(*command, options->backend);
  command->add_flag("--stats", options->stats, "draw twice, time the second frame; as --json");
  command->add_flag("--json", options->json, "machine-readable");
  command->footer(
      "Example:\n  seaway render configs/scenes/canaveral.yaml --time 5 --camera chase --out "
      "launch.png\n  seaway render configs/scenes/storm.yaml --time 3 --from 61.2,2.3,12 --yaw 300 "
      "--size 640x400 --grid 512x1024 --compare reference --out storm.png");
  command->callback([=, &chosen] { chosen = [=] { return runRender(*options, std::cout); }; });
}

}  // namespace seaway::bridge
