#include "sim_bridge/commands/render.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <nlohmann/json.hpp>

#include "render/compare_frames.h"
#include "render/headless_context.h"
#include "render/technique_choice.h"
#include "sim_bridge/commands/free_camera.h"
#include "sim_bridge/commands/options.h"
#include "sim_bridge/output/frame_files.h"
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
  nlohmann::ordered_json description;  ///< of the frame, where the report holds it
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
    out << options.out << ": camera '" << camera.name << "' at " << options.time << " s, " << size.x
        << "x" << size.y << ", drawn in " << drawn.drawMs << " ms by " << stats.technique
        << (stats.variant.empty() ? "" : "/" + stats.variant) << " on " << stats.renderer << '\n';
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
  if (!drawn.description.is_null()) result["frame"] = drawn.description;
  out << result.dump(2) << '\n';
}

/// What the command line asks for, checked before any work.
struct Request {
  Scene scene;
  SceneCamera camera;
  glm::ivec2 size;
  render::TechniqueChoice choice;
  FrameFiles files;
};

Request requestFrom(const RenderOptions& options) {
  render::requireBackend(options.backend);
  Request request{loadScene(options.scene), {}, {}, {}, {}};
  requireTime(options.time);
  request.camera =
      options.from.empty() ? findCamera(request.scene, options.camera) : freeCamera(options);
  if (options.from.empty()) refuseFreeCameraOptions(options);
  request.size = options.size.empty() ? request.scene.run.size : parseSize(options.size);
  request.choice = {
      .technique = options.technique,
      .variant = options.variant,
      .grid = options.grid.empty() ? request.scene.accuracy.grid : parseGrid(options.grid),
      .backend = options.backend};
  if (!options.compare.empty() && options.compare != "reference") {
    throw InputError("--compare: '" + options.compare + "' is not allowed; must be: reference");
  }
  request.files = {.depth = options.depth,
                   .normals = options.normals,
                   .radiance = options.radiance,
                   .labels = options.labels,
                   .json = options.frameJson};
  requireWritablePicture(options.out);
  requireWritable(request.files);
  applyLens(options.lens, request.size, request.camera);
  if (!options.compare.empty() && request.camera.distortion) {
    throw InputError("--compare: not with distortion; it compares pinholes");
  }
  requireMemoryForPicture(request.size * options.lens.samples);
  return request;
}

render::FrameComparison compare(const RenderOptions& options, const Request& request,
                                render::View view, const render::Frame& frame) {
  EffectLedger ledger(request.scene.effects);
  view.effects = &ledger;
  view.wantsNormals = true;
  view.wantsLabels = view.wantsRadiance = false;
  view.samplesPerSide = 1;
  const auto reference = render::makeTechnique(
      {.technique = options.compare, .variant = "automatic", .grid = request.choice.grid});
  return render::compareFrames(view.camera, frame, reference->draw(view));
}

Drawn draw(const RenderOptions& options, const Request& request) {
  const auto technique = render::makeTechnique(request.choice);
  const Sea sea = buildSea(request.scene);
  Simulation simulation = replayWithProgress(request.scene, sea, options.time);
  simulation.attend({.cameras = {request.camera}, .places = {}});
  SceneView sceneView(request.scene);
  EffectLedger ledger(request.scene.effects);
  render::View view = sceneView.view(simulation, request.camera, request.size, ledger);
  askFor(request.files, view);
  view.wantsLabels = view.wantsLabels || options.json;
  view.samplesPerSide = options.lens.samples;
  Drawn drawn;
  if (options.stats) technique->drawInto(view, drawn.frame);  // sets up what stays
  const Stopwatch watch;
  technique->drawInto(view, drawn.frame);
  drawn.drawMs = watch.milliseconds();
  const DescribedFrame described{request.scene, sea.geodesy,           request.camera.name,
                                 view,          sceneView.instances(), drawn.frame,
                                 ledger};
  if (options.json) drawn.description = frameJson(described);
  write(request.files, described);
  writePicture(options.out, drawn.frame.colour);
  if (!options.compare.empty()) drawn.comparison = compare(options, request, view, drawn.frame);
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
  addLensOptions(command, options.lens);
  addSamplesOption(command, options.lens.samples);
}

void addFileOptions(CLI::App& command, RenderOptions& options) {
  command.add_option("--out", options.out, "PNG file to write")->required()->check(mustBeNamed);
  command.add_option("--depth", options.depth, "EXR file of axial distances, m, +inf for sky")
      ->check(mustBeNamed);
  command.add_option("--normals", options.normals, "EXR file of unit normals, east north up")
      ->check(mustBeNamed);
  command
      .add_option("--radiance", options.radiance,
                  "EXR file of linear radiance, not tone-mapped; with Z where --depth names it too")
      ->check(mustBeNamed);
  command
      .add_option(
          "--labels", options.labels,
          "PNG file of what pixels show: sky 0, water 1, foam 2, ground 3, object 4, from 16 "
          "on one vessel each (--frame-json names them)")
      ->check(mustBeNamed);
  command
      .add_option("--frame-json", options.frameJson,
                  "JSON file of time, camera, vessels' poses and boxes, labels, effects on")
      ->check(mustBeNamed);
}

}  // namespace

int runRender(const RenderOptions& options, std::ostream& out) {
  const Request request = requestFrom(options);
  const Drawn drawn = draw(options, request);
  report(options, request.camera, drawn, out);
  return 0;
}

void addRenderCommand(CLI::App& app, ChosenCommand& chosen) {
  auto* command = app.add_subcommand("render", "Draw one picture of a scene");
  auto options = std::make_shared<RenderOptions>();
  command->add_option("SCENE", options->scene, "scene file")->required();
  command->add_option("--time", options->time, "seconds since the scene's epoch, >= 0")->required();
  addCameraOptions(*command, *options);
  addFileOptions(*command, *options);
  command->add_option(
      "--technique", options->technique,
      "projected_grid (default), radial_grid, post_process, naive_grid or reference");
  command->add_option("--variant", options->variant,
                      "of projected_grid: automatic, software, cpu_vertices, gpu, "
                      "cpu_vertices_gpu_normals or marched (default automatic: the fastest)");
  command->add_option("--grid", options->grid, "COLUMNSxROWS of vertices (default: the scene's)");
  command->add_option("--compare", options->compare,
                      "reference: say how far the picture is from a ray-cast of the same sea");
  addBackendOption(*command, options->backend);
  command->add_flag("--stats", options->stats, "draw twice, time the second frame; as --json");
  command->add_flag("--json", options->json, "machine-readable, with the frame's description");
  command->footer(
      "Example:\n  seaway render configs/scenes/canaveral.yaml --time 5 --camera chase --out "
      "launch.png\n  seaway render configs/scenes/storm.yaml --time 3 --from 61.2,2.3,12 --yaw 300 "
      "--size 640x400 --grid 512x1024 --compare reference --out storm.png");
  command->callback([=, &chosen] { chosen = [=] { return runRender(*options, std::cout); }; });
}

}  // namespace seaway::bridge
