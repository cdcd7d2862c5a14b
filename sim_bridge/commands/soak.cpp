#include "sim_bridge/commands/soak.h"

#include <spdlog/fmt/fmt.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <nlohmann/json.hpp>

#include "render/headless_context.h"
#include "sim_bridge/commands/options.h"
#include "sim_bridge/output/atomic_file.h"
#include "sim_bridge/output/stopwatch.h"
#include "sim_bridge/scene/scene_loader.h"
#include "sim_bridge/selftest/soak.h"
#include "surface/input_error.h"

namespace seaway::bridge {
namespace {

constexpr double mebibyte = 1024.0 * 1024.0;

/// What memory may stray by once it has settled, of what it was then.
constexpr double allowedChange = 0.02;

nlohmann::ordered_json asJson(const SoakReading& reading) {
  return {{"time_s", reading.time},
          {"resident_bytes", reading.residentBytes},
          {"heap_bytes", reading.heapBytes},
          {"step_us", {{"p50", reading.stepMedian}, {"p99", reading.step99}}}};
}

void writeRow(const SoakReading& reading, std::ostream& out) {
  out << fmt::format("{:>12.2f} {:>14.2f} {:>10.2f} {:>14.1f} {:>14.1f}\n", reading.time / 3600.0,
                     static_cast<double>(reading.residentBytes) / mebibyte,
                     static_cast<double>(reading.heapBytes) / mebibyte, reading.stepMedian,
                     reading.step99)
      << std::flush;
}

struct Verdict {
  double resident = 0.0, heap = 0.0;  // how far memory strays once it has settled, as a share
  bool sound = false;
};

Verdict verdictOn(const SoakResult& result, double settled) {
  Verdict verdict{memoryChange(result.readings, &SoakReading::residentBytes, settled),
                  memoryChange(result.readings, &SoakReading::heapBytes, settled)};
  verdict.sound =
      result.resumes && verdict.resident <= allowedChange && verdict.heap <= allowedChange;
  return verdict;
}

void writeVerdict(const SoakResult& result, const Verdict& verdict, double settled, double seconds,
                  std::ostream& out) {
  const double simulated = result.readings.back().time;
  out << fmt::format(
      "{:.2f} h in {:.0f} s of wall time ({:.0f} times real time), {} steps, {} frames\n"
      "step: median {:.1f} us, 99 % within {:.1f} us, longest {:.1f} us\n"
      "memory after {:.2f} h: within {:.2f} % resident (allowed {:.0f} %), {:.2f} % on the heap\n"
      "resumed at {:.2f} h: {}\n",
      simulated / 3600.0, seconds, simulated / seconds, result.stepCount, result.frames,
      result.steps.percentile(0.5), result.steps.percentile(0.99), result.steps.percentile(1.0),
      settled / 3600.0, 100.0 * verdict.resident, 100.0 * allowedChange, 100.0 * verdict.heap,
      result.resumedFrom / 3600.0,
      result.resumes ? "the same bits at the end" : "OTHER bits at the end");
}

void writeJson(const SoakResult& result, const Verdict& verdict, double seconds,
               std::ostream& out) {
  nlohmann::ordered_json readings = nlohmann::ordered_json::array();
  for (const SoakReading& reading : result.readings) readings.push_back(asJson(reading));
  out << nlohmann::ordered_json{{"sound", verdict.sound},
                                {"readings", readings},
                                {"resident_change", verdict.resident},
                                {"heap_change", verdict.heap},
                                {"step_us",
                                 {{"p50", result.steps.percentile(0.5)},
                                  {"p99", result.steps.percentile(0.99)},
                                  {"most", result.steps.percentile(1.0)}}},
                                {"steps", result.stepCount},
                                {"frames", result.frames},
                                {"resumed_from_s", result.resumedFrom},
                                {"resumes", result.resumes},
                                {"wall_s", seconds}}
             .dump(2)
      << '\n';
}

Scene sceneFor(const SoakOptions& options) {
  requireInRange("--every", options.every, Range::between(0.0, 1e7), "s");
  requireInRange("--settled", options.settled, Range::within(0.0, 1e7), "s");
  Scene scene = loadScene(options.scene);
  if (options.hours) {
    requireInRange("--hours", *options.hours, Range::between(0.0, 1e4), "h");
    scene.run.duration = 3600.0 * *options.hours;
  }
  if (scene.run.duration < options.settled + options.every) {
    throw InputError(
        fmt::format("--hours: {} s in all is not allowed; memory is to settle for {} s and then to "
                    "be read once more after {} s (--settled, --every)",
                    scene.run.duration, options.settled, options.every));
  }
  return scene;
}

}  // namespace

int runSoak(const SoakOptions& options, std::ostream& out) {
  render::requireBackend(options.backend);
  const Scene scene = sceneFor(options);
  SoakSettings settings{
      .every = options.every,
      .folder = options.out.empty() ? "out/" + scene.file.stem().string() : options.out,
      .backend = options.backend};
  requireWritableFolder(settings.folder);
  if (!options.json) {
    out << fmt::format("{:>12} {:>14} {:>10} {:>14} {:>14}\n", "simulated h", "resident MiB",
                       "heap MiB", "step p50 us", "step p99 us");
  }
  const Stopwatch watch;
  const SoakResult result = soak(scene, settings, [&](const SoakReading& reading) {
    if (!options.json) writeRow(reading, out);
  });
  const double seconds = watch.milliseconds() / 1000.0;
  const Verdict verdict = verdictOn(result, options.settled);
  if (options.json) {
    writeJson(result, verdict, seconds, out);
  } else {
    writeVerdict(result, verdict, options.settled, seconds, out);
  }
  return verdict.sound ? 0 : 1;
}

void addSoakCommand(CLI::App& app, ChosenCommand& chosen) {
  auto* command = app.add_subcommand(
      "soak", "Sail a scene for long: memory, step times, and whether it can be resumed");
  auto options = std::make_shared<SoakOptions>();
  command->add_option("SCENE", options->scene, "scene file")->required();
  command
      ->add_option("--out", options->out,
                   "folder for telemetry and the checkpoint (default: out/ and the scene's name)")
      ->check(mustBeNamed);
  command->add_option("--hours", options->hours, "simulated hours (default: the scene's duration)");
  command->add_option("--every", options->every,
                      "simulated seconds between readings of memory and steps (default 3600)");
  command->add_option("--settled", options->settled,
                      "simulated seconds after which memory must stay within 2 % (default 10800)");
  addBackendOption(*command, options->backend);
  command->add_flag("--json", options->json, "machine-readable");
  command->footer("Example:\n  seaway soak configs/scenes/soak.yaml --out out/soak");
  command->callback([=, &chosen] { chosen = [=] { return runSoak(*options, std::cout); }; });
}

}  // namespace seaway::bridge
