#include "sim_bridge/commands/options.h"

#include <CLI/CLI.hpp>
#include <charconv>

#include "sim_bridge/scene/schema.h"
#include "surface/field/wave_field.h"
#include "surface/input_error.h"

namespace seaway::bridge {

glm::ivec2 parseSize(const std::string& text) {
  constexpr int largest = 8192;
  glm::ivec2 size{0};
  const char* end = text.data() + text.size();
  const auto width = std::from_chars(text.data(), end, size.x);
  const bool separated = width.ec == std::errc{} && width.ptr != end && *width.ptr == 'x';
  const auto height = separated ? std::from_chars(width.ptr + 1, end, size.y) : width;
  if (!separated || height.ec != std::errc{} || height.ptr != end) {
    throw InputError("--size: '" + text + "' is not WIDTHxHEIGHT, such as 1280x720");
  }
  if (size.x < 1 || size.y < 1 || size.x > largest || size.y > largest) {
    throw InputError("--size: " + text + " is not allowed; width and height must be in [1, 8192]");
  }
  return size;
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
  command.add_option("--backend", backend,
                     "graphics context: osmesa (software), egl, or egl:N for EGL device N")
      ->capture_default_str();
}

}  // namespace seaway::bridge
