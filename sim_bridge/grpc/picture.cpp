#include "sim_bridge/grpc/picture.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "render/png.h"
#include "sim_bridge/scene/schema.h"

namespace seaway::bridge::rpc {
namespace {

using v1::FreeCamera;
using v1::RenderRequest;

SceneCamera cameraOf(const FreeCamera& asked) {
  const auto require = [](const char* field, double value, double least, double most) {
    requireInRange(std::string("free.") + field, value, Range::within(least, most), "");
  };
  const double fov = asked.fov_deg() == 0.0 ? 60.0 : asked.fov_deg();
  require("latitude_deg", asked.latitude_deg(), -90.0, 90.0);
  require("longitude_deg", asked.longitude_deg(), -180.0, 360.0);
  require("height_m", asked.height_m(), -1000.0, 10000.0);
  require("yaw_deg", asked.yaw_deg(), -360.0, 360.0);
  require("pitch_deg", asked.pitch_deg(), -90.0, 90.0);
  require("roll_deg", asked.roll_deg(), -360.0, 360.0);
  require("fov_deg", fov, 1.0, 170.0);
  SceneCamera camera;
  camera.name = "free";
  camera.place = CameraPlace{asked.latitude_deg(), asked.longitude_deg(), asked.height_m()};
  camera.yaw_deg = asked.yaw_deg();
  camera.pitch_deg = asked.pitch_deg();
  camera.roll_deg = asked.roll_deg();
  camera.fieldOfView_deg = fov;
  return camera;
}

void requireSize(const WaterHost& host, const RenderRequest& request) {
  if (request.width() == 0 && request.height() == 0) return;
  const auto require = [&](const char* field, std::uint32_t value) {
    if (value >= 1 && value <= host.limits.pixels) return;
    throw badValue(field, static_cast<double>(value),
                   "must be in [1, " + std::to_string(host.limits.pixels) +
                       "], or width and height both 0 for the scene's own size");
  };
  require("width", request.width());
  require("height", request.height());
}

void requireCamera(const WaterHost& host, const std::string& name) {
  const std::vector<std::string> names = host.frames.cameras();
  const bool known = name.empty() ? !names.empty() : std::ranges::find(names, name) != names.end();
  if (known) return;
  std::string all;
  for (const std::string& other : names) all += (all.empty() ? "" : ", ") + other;
  throw RpcFault(grpc::StatusCode::NOT_FOUND, Refusal::notFound,
                 "camera: '" + name + "' is not there; must be one of: " + all +
                     (all.empty() ? "none; use free" : ""));
}

}  // namespace

void drawPicture(WaterHost& host, const RenderRequest& request, v1::RenderResponse& response,
                 const CallWatch& watch) {
  requireSize(host, request);
  FrameRequest wanted;
  wanted.t = host.timeOf(request);
  wanted.size = {static_cast<int>(request.width()), static_cast<int>(request.height())};
  if (request.has_free()) {
    wanted.own = cameraOf(request.free());
  } else {
    requireCamera(host, request.camera());
    wanted.camera = request.camera();
  }
  if (!v1::PictureFormat_IsValid(request.format())) {
    throw badValue("format", static_cast<double>(request.format()), "must be in [0, 1]");
  }
  watch.check();
  const auto frame = host.frames.draw(wanted);
  watch.check();
  const render::ColourImage& image = frame->colour;
  response.set_time_s(wanted.t);
  response.set_width(static_cast<std::uint32_t>(image.size.x));
  response.set_height(static_cast<std::uint32_t>(image.size.y));
  if (request.format() == v1::PICTURE_FORMAT_PNG) {
    response.set_picture(render::pngBytes(image));
  } else {
    response.set_picture(image.rgb.data(), image.rgb.size());
  }
  if (request.depth()) {
    response.mutable_depth_m()->Add(frame->depth.metres.begin(), frame->depth.metres.end());
  }
}

}  // namespace seaway::bridge::rpc
