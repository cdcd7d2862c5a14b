#include "sim_bridge/commands/free_camera.h"

#include <CLI/StringTools.hpp>
#include <charconv>
#include <utility>

#include "sim_bridge/scene/schema.h"
#include "surface/input_error.h"

namespace seaway::bridge {
namespace {

double numberIn(const std::string& text, const std::string& whole) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) {
    throw InputError("--from: '" + whole + "' is not LAT,LON,HEIGHT, such as 28.9,-78.5,12");
  }
  return value;
}

CameraPlace placeFrom(const std::string& text) {
  const std::vector<std::string> parts = CLI::detail::split(text, ',');
  if (parts.size() != 3) numberIn("", text);
  const CameraPlace place{numberIn(parts[0], text), numberIn(parts[1], text),
                          numberIn(parts[2], text)};
  requireInRange("--from latitude", place.latitude_deg, Range::within(-90.0, 90.0), "degrees");
  requireInRange("--from longitude", place.longitude_deg, Range::within(-360.0, 360.0), "degrees");
  requireInRange("--from height", place.height, Range::within(-1e5, 1e6), "m");
  return place;
}

}  // namespace

SceneCamera freeCamera(const RenderOptions& options) {
  if (!options.camera.empty()) {
    throw InputError("--from: not together with --camera, which names one of the scene's");
  }
  SceneCamera camera;
  camera.name = "free";
  camera.place = placeFrom(options.from);
  camera.yaw_deg = options.yaw_deg.value_or(0.0);
  camera.pitch_deg = options.pitch_deg.value_or(0.0);
  camera.roll_deg = options.roll_deg.value_or(0.0);
  camera.fieldOfView_deg = options.fieldOfView_deg.value_or(60.0);
  requireInRange("--yaw", camera.yaw_deg, Range::within(-720.0, 720.0), "degrees");
  requireInRange("--pitch", camera.pitch_deg, Range::within(-90.0, 90.0), "degrees");
  requireInRange("--roll", camera.roll_deg, Range::within(-360.0, 360.0), "degrees");
  requireInRange("--fov", camera.fieldOfView_deg, Range::within(0.01, 179.0), "degrees");
  return camera;
}

void refuseFreeCameraOptions(const RenderOptions& options) {
  const std::pair<const char*, bool> given[] = {{"--yaw", options.yaw_deg.has_value()},
                                                {"--pitch", options.pitch_deg.has_value()},
                                                {"--roll", options.roll_deg.has_value()},
                                                {"--fov", options.fieldOfView_deg.has_value()}};
  for (const auto& [name, isGiven] : given) {
    if (isGiven) throw InputError(std::string(name) + ": has no effect without --from");
  }
}

}  // namespace seaway::bridge
