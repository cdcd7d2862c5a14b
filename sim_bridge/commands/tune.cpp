#include "sim_bridge/commands/tune.h"

#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>

#include "render/headless_context.h"
#include "sim_bridge/commands/options.h"
#include "sim_bridge/commands/performance_json.h"
#include "sim_bridge/cost/study.h"
#include "sim_bridge/cost/tuning.h"
#include "sim_bridge/output/atomic_file.h"
#include "sim_bridge/output/progress.h"
#include "sim_bridge/scene/scene_loader.h"
#include "sim_bridge/scene/sea.h"
#include "sim_bridge/selftest/yaml_json.h"
#include "surface/input_error.h"

namespace seaway::bridge {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

std::string textOf(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// The scene's accuracy with the settings that were found.
Json tunedAccuracy(const Json& scene, const Tuning& tuning) {
  Json accuracy = scene.value("accuracy", Json::object());
  if (tuning.tolerance) accuracy["motion_tolerance_m"] = *tuning.tolerance;
  if (tuning.grid) accuracy["grid"] = {tuning.grid->x, tuning.grid->y};
  if (tuning.wakeCell) accuracy["wakes"]["cell_m"] = *tuning.wakeCell;
  return accuracy;
}

/// The text of a file whose top is a block mapping, without some of its keys.
std::string without(const std::string& text, const YamlValue& top,
                    const std::vector<std::string>& keys) {
  const auto isOut = [&](const std::string& name) {
    return std::find(keys.begin(), keys.end(), name) != keys.end();
  };
  std::string kept;
  std::istringstream lines(text);
  int number = 1;
  for (std::string line; std::getline(lines, line); ++number) {
    const YamlValue* owner = nullptr;
    for (const YamlValue& entry : top.values) {
      if (entry.line <= number) owner = &entry;
    }
    // A remark at the margin belongs to what follows.
    const bool isRemark = !line.empty() && line[0] == '#';
    if (!owner || !isOut(owner->name) || isRemark) kept += line + '\n';
  }
  return kept;
}

/// The scene's text with the found settings; remarks outside the blocks that change stay.
std::string tunedText(const TuneOptions& options, const Tuning& tuning) {
  const fs::path file = options.scene;
  const YamlValue top = readYaml(file);
  Json scene = jsonFromYaml(top);
  const Json changed{{"accuracy", tunedAccuracy(scene, tuning)},
                     {"tuned", performanceJson(tuning.foreseen)}};
  const std::string origin =
      "# Tuned by `seaway tune " + options.scene + "` on " + machineLine() + ".\n";
  std::error_code ignored;
  const bool sameFolder = fs::equivalent(fs::absolute(file).parent_path(),
                                         fs::absolute(options.out).parent_path(), ignored);
  const std::string text = textOf(file);
  const bool isBlock = text.find_first_not_of(" \n") == text.npos || text[0] != '{';
  if (sameFolder && isBlock) {
    return without(text, top, {"accuracy", "tuned"}) + origin + yamlFromJson(changed);
  }
  // Its paths are relative to its folder.
  spdlog::warn("{} is in another folder: paths become absolute, remarks are left out", options.out);
  makePathsAbsolute(scene, fs::absolute(file).parent_path());
  scene.update(changed);
  return origin + yamlFromJson(scene);
}

void overrideWith(const Performance& options, Scene& scene) {
  const auto take = [](const std::optional<double>& option, std::optional<double>& setting,
                       const char* name, const char* unit) {
    if (!option) return;
    requireInRange(name, *option, Range::above(0.0), unit);
    setting = option;
  };
  take(options.height, scene.accuracy.wanted.height, "--height-m", "m");
  take(options.position, scene.accuracy.wanted.position, "--pixel", "px");
  take(options.query, scene.budget.query, "--query-ns", "ns");
  take(options.frame, scene.budget.frame, "--frame-ms", "ms");
  take(options.step, scene.budget.step, "--step-us", "us");
}

void writeTable(const Tuning& tuning, std::ostream& out) {
  const auto line = [&](const char* name, const std::string& value) {
    out << fmt::format("{:<30} {}\n", name, value);
  };
  if (tuning.tolerance) {
    line("accuracy.motion_tolerance_m", fmt::format("{:.4g}", *tuning.tolerance));
  }
  if (tuning.grid) line("accuracy.grid", fmt::format("[{}, {}]", tuning.grid->x, tuning.grid->y));
  if (tuning.wakeCell) line("accuracy.wakes.cell_m", fmt::format("{:g}", *tuning.wakeCell));
  const Json foreseen = performanceJson(tuning.foreseen);
  for (const auto& [key, value] : foreseen.items()) {
    line(("foreseen " + key).c_str(), fmt::format("{:.4g}", value.get<double>()));
  }
}

}  // namespace

int runTune(const TuneOptions& options, std::ostream& out) {
  render::requireBackend(options.backend);
  Scene scene = loadScene(options.scene);
  overrideWith(options.wanted, scene);
  requireWritableFile(options.out);
  const Sea sea = buildSea(scene);
  Progress progress("tune", 3);
  const Tuning tuning =
      tune(scene, sea, options.backend, [&](std::size_t done) { progress.update(done); });
  const std::string text = tunedText(options, tuning);
  sceneFromText(text, fs::absolute(options.out).parent_path());
  AtomicFile file(options.out);
  file.stream() << text;
  file.commit();
  if (options.json) {
    Json json{{"scene", options.out},
              {"machine", machineLine()},
              {"foreseen", performanceJson(tuning.foreseen)}};
    if (tuning.tolerance) json["settings"]["motion_tolerance_m"] = *tuning.tolerance;
    if (tuning.grid) json["settings"]["grid"] = {tuning.grid->x, tuning.grid->y};
    if (tuning.wakeCell) json["settings"]["wake_cell_m"] = *tuning.wakeCell;
    out << json.dump(2) << '\n';
  } else {
    writeTable(tuning, out);
  }
  return 0;
}

void addTuneCommand(CLI::App& app, ChosenCommand& chosen) {
  auto* command = app.add_subcommand(
      "tune", "Find the settings that a scene's accuracy and budget ask for, on this machine");
  auto options = std::make_shared<TuneOptions>();
  command->add_option("SCENE", options->scene, "scene file")->required();
  command->add_option("--out", options->out, "scene file to write")->required()->check(mustBeNamed);
  command->add_option("--height-m", options->wanted.height,
                      "error of heights, one standard deviation (default: accuracy.height_m)");
  command->add_option("--pixel", options->wanted.position,
                      "error of the sea's place in pictures, rms px (default: accuracy.pixel)");
  command->add_option("--query-ns", options->wanted.query,
                      "cost of a point's height in batches (default: budget.query_ns)");
  command->add_option("--frame-ms", options->wanted.frame,
                      "cost of a frame, mean of the cameras (default: budget.frame_ms)");
  command->add_option("--step-us", options->wanted.step,
                      "cost of a step of the vessels (default: budget.step_us)");
  addBackendOption(*command, options->backend);
  command->add_flag("--json", options->json, "machine-readable");
  command->footer(
      "Example:\n  seaway tune configs/scenes/canaveral.yaml --out configs/scenes/tuned.yaml "
      "--height-m 0.1 --frame-ms 80");
  command->callback([=, &chosen] { chosen = [=] { return runTune(*options, std::cout); }; });
}

}  // namespace seaway::bridge
