#include "sim_bridge/commands/run.h"

#include <spdlog/fmt/fmt.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <iostream>
#include <limits>
#include <optional>

#include "render/headless_context.h"
#include "render/technique_choice.h"
#include "sim_bridge/commands/lens_options.h"
#include "sim_bridge/commands/options.h"
#include "sim_bridge/commands/performance_json.h"
#include "sim_bridge/commands/run_output.h"
#include "sim_bridge/cost/tuning.h"
#include "sim_bridge/output/checkpoint.h"
#include "sim_bridge/output/picture_file.h"
#include "sim_bridge/output/progress.h"
#include "sim_bridge/output/stopwatch.h"
#include "sim_bridge/output/telemetry.h"
#include "sim_bridge/output/video_file.h"
#include "sim_bridge/scene/scene_loader.h"
#include "sim_bridge/scene_view.h"
#include "surface/input_error.h"

namespace seaway::bridge {
namespace {

Scene sceneFor(const RunOptions& options) {
  Scene scene = loadScene(options.scene);
  if (options.duration) {
    requireInRange("--duration", *options.duration, Range::between(0.0, 1e7), "s");
    scene.run.duration = *options.duration;
  }
  if (options.framesPerSecond) {
    requireInRange("--fps", *options.framesPerSecond, Range::within(0.0, 1000.0), "1/s");
    scene.run.framesPerSecond = *options.framesPerSecond;
  }
  if (options.seed) {
    requireInRange("--seed", static_cast<double>(*options.seed), Range::atLeast(0.0), "");
    scene.sea.seed = *options.seed;
  }
  if (!options.size.empty()) scene.run.size = parseSize(options.size);
  return scene;
}

/// Draws what a scene's cameras see. Without cameras or frames no context is made.
class Cameras {
 public:
  Cameras(const Scene& scene, const RunOptions& options, const RunFolder& folder,
          RunSummary& summary)
      : scene_(scene), options_(options), folder_(folder), summary_(summary), view_(scene) {
    if (scene.cameras.empty() || scene.run.framesPerSecond == 0.0) return;
    technique_ = render::makeTechnique({.grid = scene.accuracy.grid, .backend = options.backend});
    if (!options.video.empty()) {
      video_.emplace(options.video, scene.run.size, scene.run.framesPerSecond);
    }
  }

  void draw(const Simulation& moment, long long index) {
    for (std::size_t i = 0; i < scene_.cameras.size(); ++i) {
      const SceneCamera& camera = scene_.cameras[i];
      EffectLedger ledger(scene_.effects);
      const FrameFiles files = folder_.files(i, index);
      const Stopwatch drawing;
      render::View view = view_.view(moment, camera, scene_.run.size, ledger);
      askFor(files, view);
      view.samplesPerSide = options_.samples;
      technique_->drawInto(view, frame_);
      const double milliseconds = drawing.milliseconds();
      summary_.timingsMs["draw"] += milliseconds;
      if (hasDrawn_) summary_.frameTimes.add(1e3 * milliseconds);
      for (const auto& [pass, ms] : frame_.stats.passesMs) summary_.passesMs[pass] += ms;
      const Stopwatch writing;
      write(files,
            {scene_, moment.sea().geodesy, camera.name, view, view_.instances(), frame_, ledger});
      writePicture(folder_.frame(i, index), frame_.colour);
      if (video_ && i == 0) video_->write(frame_.colour);
      summary_.timingsMs["write"] += writing.milliseconds();
      summary_.lastFrame = frame_.stats;
    }
    hasDrawn_ = true;
  }

  void finish() {
    if (video_) video_->commit();
  }

 private:
  const Scene& scene_;
  const RunOptions& options_;
  const RunFolder& folder_;
  RunSummary& summary_;
  SceneView view_;
  std::unique_ptr<render::RenderTechnique> technique_;
  std::optional<VideoFile> video_;
  render::Frame frame_;
  bool hasDrawn_ = false;  // what the first frames make, later ones find
};

/// Frames of each camera: at 0, 1/fps, … before the end.
long long frameCount(const Scene& scene) {
  if (scene.cameras.empty()) return 0;
  return static_cast<long long>(std::ceil(scene.run.duration * scene.run.framesPerSecond - 1e-9));
}

// Whole steps up to `t`, a row of telemetry each.
void sail(Simulation& simulation, double t, Telemetry& telemetry, RunSummary& summary,
          Progress& progress, const std::function<void()>& stepped) {
  const Stopwatch watch;
  while (simulation.nextTime() <= t * (1.0 + 1e-12)) {
    const Stopwatch step;
    simulation.step();
    const double milliseconds = step.milliseconds();
    summary.stepTimes.add(1e3 * milliseconds);
    summary.stepMs += milliseconds;
    telemetry.write(simulation);
    stepped();
    progress.update(static_cast<std::size_t>(++summary.steps));
  }
  summary.timingsMs["motion"] += watch.milliseconds();
}

/// What a run did of what was foreseen, of the same work: pictures and queries are held against the
/// truth at its end; frames count from the second on and only where they were plain ones of the
/// scene's size; steps count without telemetry and checkpoints.
Performance achievedBy(const Simulation& simulation, const RunOptions& options,
                       const RunSummary& summary) {
  Performance achieved;
  const Scene& scene = simulation.scene();
  const Performance& foreseen = scene.tuned;
  if (foreseen.height || foreseen.query) {
    const Setting queries = measureQueries(scene, simulation.sea(), simulation.time());
    achieved.height = queries.error;
    achieved.query = queries.cost;
  }
  const bool plain = options.also.empty() && options.samples == 1 && options.size.empty();
  if (foreseen.frame && plain && summary.framesDrawn > 1 && !scene.cameras.empty()) {
    achieved.frame = 1e-3 * summary.frameTimes.percentile(0.5);
  }
  if (foreseen.position && summary.framesDrawn > 0 && !scene.cameras.empty()) {
    achieved.position = measurePosition(scene, simulation, options.backend);
  }
  if (foreseen.step && summary.steps > 0) {
    achieved.step = 1e3 * summary.stepMs / static_cast<double>(summary.steps);
  }
  return achieved;
}

/// A run at its start, or as a checkpoint has it.
Simulation begun(const Scene& scene, const Sea& sea, const std::optional<Checkpoint>& from) {
  Audience audience;
  if (frameCount(scene) > 0) audience.cameras = scene.cameras;
  if (from) return Simulation::resumed(scene, sea, audience, from->state);
  Simulation simulation(scene, sea);
  if (frameCount(scene) > 0) simulation.attend(audience);
  return simulation;
}

/// Writes checkpoints as often as is wanted.
class Checkpoints {
 public:
  Checkpoints(const RunOptions& options, const Scene& scene, double start)
      : path_(options.checkpoint), scene_(scene) {
    if (options.checkpointEvery) interval_ = *options.checkpointEvery;
    if (!path_.empty()) next_ = nextAfter(start);
  }

  void stepped(const Simulation& simulation, Telemetry& telemetry) {
    if (simulation.time() < next_ * (1.0 - 1e-12)) return;
    write(simulation, telemetry);
    next_ = nextAfter(simulation.time());
  }

  void finish(const Simulation& simulation, Telemetry& telemetry) const {
    if (!path_.empty()) write(simulation, telemetry);
  }

 private:
  double nextAfter(double t) const { return interval_ * (std::floor(t / interval_ + 1e-9) + 1.0); }
  void write(const Simulation& simulation, Telemetry& telemetry) const {
    writeCheckpoint(path_, scene_, {simulation.time(), simulation.state(), telemetry.keep(path_)});
  }

  std::filesystem::path path_;
  const Scene& scene_;
  double interval_ = std::numeric_limits<double>::infinity();
  double next_ = std::numeric_limits<double>::infinity();
};

void sailAndDraw(const Scene& scene, const RunOptions& options, const Sea& sea,
                 const std::optional<Checkpoint>& from, const RunFolder& folder,
                 RunSummary& summary) {
  Telemetry telemetry(folder.path(), scene, options.resume, from.value_or(Checkpoint{}));
  Simulation simulation = begun(scene, sea, from);
  if (!from) telemetry.write(simulation);
  Checkpoints checkpoints(options, scene, simulation.time());
  Cameras cameras(scene, options, folder, summary);
  const long long frames = frameCount(scene);
  Progress progress("steps", static_cast<std::size_t>(scene.run.duration / scene.run.step));
  // Those before a checkpoint were drawn before it was written.
  const double start = from ? from->time * scene.run.framesPerSecond : 0.0;
  const long long first = std::min(frames, static_cast<long long>(std::ceil(start - 1e-9)));
  summary.framesDrawn = frames - first;
  for (long long frame = first; frame < frames; ++frame) {
    const double t = static_cast<double>(frame) / scene.run.framesPerSecond;
    sail(simulation, t, telemetry, summary, progress,
         [&] { checkpoints.stepped(simulation, telemetry); });
    cameras.draw(simulation.movedTo(std::max(t, simulation.time())), frame);
    progress.update(static_cast<std::size_t>(summary.steps));
  }
  sail(simulation, scene.run.duration, telemetry, summary, progress,
       [&] { checkpoints.stepped(simulation, telemetry); });
  checkpoints.finish(simulation, telemetry);
  telemetry.commit();
  cameras.finish();
  summary.frames = frames;
  summary.achieved = achievedBy(simulation, options, summary);
}

void writeReport(const Scene& scene, const RunSummary& summary, const std::string& json,
                 const RunFolder& folder, bool asJson, std::ostream& out) {
  if (asJson) {
    out << json;
    return;
  }
  out << fmt::format(
      "{}: {} s in {:.1f} s (real-time factor {:.2f}), {} frames of {} cameras\n"
      "H_m0 asked {:.3f} m, realised {:.3f} m\n",
      folder.path().string(), summary.simulated(scene), summary.wallSeconds,
      summary.simulated(scene) / summary.wallSeconds, summary.framesDrawn, scene.cameras.size(),
      summary.hm0Asked, summary.hm0Realised);
  const auto foreseen = performanceJson(scene.tuned), achieved = performanceJson(summary.achieved);
  for (const auto& [key, value] : foreseen.items()) {
    out << fmt::format("{}: foreseen {:.4g}, {}\n", key, value.get<double>(),
                       achieved.contains(key)
                           ? fmt::format("achieved {:.4g}", achieved[key].get<double>())
                           : "not measured");
  }
}

void requireCheckpointOptions(const RunOptions& options) {
  if (options.checkpointEvery) {
    requireInRange("--checkpoint-every", *options.checkpointEvery, Range::above(0.0), "s");
    if (options.checkpoint.empty()) {
      throw InputError("--checkpoint-every needs --checkpoint FILE to write to");
    }
  }
  if (!options.checkpoint.empty()) requireWritableFile(options.checkpoint);
}

/// Whether what is asked for can be drawn and written, before any work.
void requireOutputs(const RunOptions& options, const Scene& scene, long long frames) {
  for (const std::string& word : options.also) frameFileKind(word);
  for (SceneCamera camera : scene.cameras) {
    applyLens({.intrinsics = "", .distortion = "", .samples = options.samples}, scene.run.size,
              camera);
  }
  if (frames > 0) requireMemoryForPicture(scene.run.size * options.samples);
  if (options.video.empty()) return;
  if (frames == 0) throw InputError("--video: the run draws no frames");
  requireVideo(options.video);
}

/// Whether the telemetry up to a checkpoint is there, before anything of an earlier run goes.
void requireTelemetry(const std::string& file, const Checkpoint& checkpoint, const Scene& scene) {
  const std::vector<std::string> names = telemetryFiles(scene);
  std::ostream nowhere(nullptr);
  for (std::size_t i = 0; i < std::min(names.size(), checkpoint.telemetry.size()); ++i) {
    copyKept(keptTelemetry(file, names[i]), checkpoint.telemetry[i], nowhere);
  }
}

}  // namespace

int runRun(const RunOptions& options, std::ostream& out) {
  render::requireBackend(options.backend);
  const Scene scene = sceneFor(options);
  const long long frames = frameCount(scene);
  requireCheckpointOptions(options);
  requireOutputs(options, scene, frames);
  const Stopwatch watch;
  RunSummary summary;
  std::optional<Checkpoint> from;
  if (!options.resume.empty()) from = readCheckpoint(options.resume, scene);
  if (from && from->time >= scene.run.duration) {
    throw InputError(
        options.resume, 0,
        fmt::format("was written at {} s, where a run of {} s is over; --duration says "
                    "how long the whole is",
                    from->time, scene.run.duration));
  }
  if (from) requireTelemetry(options.resume, *from, scene);
  const RunFolder folder(options.out.empty() ? "out/" + scene.file.stem().string() : options.out,
                         scene, frames, options.also);
  const Sea sea = buildSea(scene);
  if (from) summary.resumedFrom = from->time;
  summary.timingsMs["sea"] = watch.milliseconds();
  summary.also = options.also;
  summary.hm0Asked = sea.hm0Asked;
  summary.blocked = sea.blocked;
  sailAndDraw(scene, options, sea, from, folder, summary);
  summary.wallSeconds = watch.milliseconds() / 1000.0;
  summary.timingsMs["total"] = watch.milliseconds();
  summary.hm0Realised = realisedSignificantWaveHeight(sea.surface);
  const std::string json = summary.json(scene);
  folder.finish(json);
  writeReport(scene, summary, json, folder, options.json, out);
  return 0;
}

namespace {

/// The library's own conversion clamps what does not fit.
std::string fitsInteger(const std::string& text) {
  std::int64_t value = 0;
  const char* end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, value);
  const bool fits = read.ec == std::errc{} && read.ptr == end;
  return fits ? "" : "'" + text + "' is not allowed; must be a whole number in [0, 2^63 - 1]";
}

}  // namespace

void addRunCommand(CLI::App& app, ChosenCommand& chosen) {
  auto* command = app.add_subcommand("run", "Sail a scene: telemetry, camera frames, summary");
  auto options = std::make_shared<RunOptions>();
  command->add_option("SCENE", options->scene, "scene file")->required();
  command
      ->add_option("--out", options->out, "folder to write to (default: out/ and the scene's name)")
      ->check(mustBeNamed);
  command->add_option("--duration", options->duration, "simulated seconds (default: the scene's)");
  command->add_option("--fps", options->framesPerSecond,
                      "frames per simulated second, 0 for none (default: the scene's)");
  command->add_option("--size", options->size, "WIDTHxHEIGHT in pixels (default: the scene's)");
  command->add_option("--seed", options->seed, "seed of the sea (default: the scene's)")
      ->check(fitsInteger);
  command
      ->add_option("--also", options->also,
                   "what else to write of each frame, beside NNNNNN.png: json, labels, depth, "
                   "normals, radiance; several with commas")
      ->delimiter(',');
  command
      ->add_option("--video", options->video,
                   "MP4 file of the first camera's frames; the program ffmpeg makes it")
      ->check(mustBeNamed);
  addSamplesOption(*command, options->samples);
  addBackendOption(*command, options->backend);
  command
      ->add_option("--checkpoint", options->checkpoint,
                   "file to write the run's state to, at its end and as --checkpoint-every says; "
                   "telemetry so far goes beside it, as FILE.telemetry.csv and so on")
      ->check(mustBeNamed);
  command->add_option("--checkpoint-every", options->checkpointEvery,
                      "simulated seconds between checkpoints; each replaces the last");
  command
      ->add_option("--resume", options->resume,
                   "checkpoint to go on from, bit for bit: telemetry and frames are those after "
                   "it, with the numbers that they would have had")
      ->check(mustBeNamed);
  command->add_flag("--json", options->json, "print summary.json to standard output");
  command->footer(
      "Example:\n  seaway run configs/scenes/canaveral.yaml --out out/canaveral --duration 20\n  "
      "seaway run "
      "configs/scenes/canaveral.yaml --out out/set --also json,labels,depth --video out/set.mp4");
  command->callback([=, &chosen] { chosen = [=] { return runRun(*options, std::cout); }; });
}

}  // namespace seaway::bridge
