#include "sim_bridge/commands/options.h"

#include <CLI/CLI.hpp>
#include <charconv>

#include "sim_bridge/scene/schema.h"
#include "surface/field/wave_field.h"
#include "surface/input_error.h"

namespace seaway::bridge {

namespace {

/// "AxB", each in [least, largest]; `shape` and `example` say what it stands for.
glm::ivec2 parsePair(const std::string& option, const std::string& text, const std::string& shape,
                     int least, int largest) {
  glm::ivec2 pair{0};
  const char* end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, pair.x);
  const bool separated = first.ec == std::errc{} && first.ptr != end && *first.ptr == 'x';
  const auto second = separated ? std::from_chars(first.ptr + 1, end, pair.y) : first;
  if (!separated || second.ec != std::errc{} || second.ptr != end) {
    throw InputError(option + ": '" + text + "' is not " + shape);
  }
  if (pair.x < least || pair.y < least || pair.x > largest || pair.y > largest) {
    throw InputError(option + ": " + text + " is not allowed; both must be in [" +
                     std::to_string(least) + ", " + std::to_string(largest) + "]");
  }
  return pair;
}

}  // namespace

glm::ivec2 parseSize(const std::string& text) {
  return parsePair("--size", text, "WIDTHxHEIGHT, such as 1280x720", 1, 8192);
}

glm::ivec2 parseGrid(const std::string& text) {
  return parsePair("--grid", text, "COLUMNSxROWS, such as 256x512", 2, 4096);
}

double requireTime(double time) {
  requireInRange("--time", time, Range::within(0.0, 1e9), "s");
  return time;
}

double requireSeaTime(double time) {
  requireInRange("--time", time, Range::within(-WaveField::latest, WaveField::latest), "s");
  return time;
}

std::string mustBeNamed(const std::string& path) {
  return path.empty() ? "'' is not allowed; must name a file or folder" : "";
}

void overrideModel(Scene& scene, const std::string& model) {
  if (model != "group" && model != "perlin") {
    throw InputError("--model: '" + model + "' is not allowed; must be one of: group, perlin");
  }
  if (std::holds_alternative<FileState>(scene.sea.state) ||
      std::holds_alternative<FittedSeaState>(scene.sea.state)) {
    throw InputError(scene.file.string(), 0,
                     "--model has no effect: key 'sea.state' lists the octaves themselves");
  }
  scene.sea.model = model == "group" ? OctaveKind::group : OctaveKind::perlin;
}

void addBackendOption(CLI::App& command, std::string& backend) {
  command
      .add_option("--backend", backend,
                  "graphics context: osmesa (software), egl, or egl:N for EGL device N")
      ->capture_default_str();
}

}  // namespace seaway::bridge
