#include "sim_bridge/service/shm_service.h"

#include <spdlog/spdlog.h>

#include <CLI/CLI.hpp>
#include <utility>

#include "sim_bridge/scene/schema.h"
#include "sim_bridge/shm/sea_host.h"
#include "sim_bridge/shm/shm_endpoint.h"
#include "surface/input_error.h"

namespace seaway::bridge {
namespace {

Refusal refusalOf(seaway_shm_status status) {
  switch (status) {
    case SEAWAY_SHM_TOO_LARGE:
    case SEAWAY_SHM_NO_SLOT:
      return Refusal::tooLarge;
    case SEAWAY_SHM_BAD_VALUE:
      return Refusal::badValue;
    case SEAWAY_SHM_NOT_FOUND:
      return Refusal::notFound;
    case SEAWAY_SHM_MALFORMED:
      return Refusal::malformed;
    default:
      return Refusal::failed;
  }
}

class MeterObserver : public shm::Observer {
 public:
  explicit MeterObserver(Meter& meter) : meter_(meter) {}
  void answered(std::size_t points, double seconds) noexcept override {
    meter_.answered(points, seconds);
  }
  void refused(seaway_shm_status why) noexcept override { meter_.refused(refusalOf(why)); }
  void pictureSent(double seconds) noexcept override { meter_.frameSent(seconds); }

 private:
  Meter& meter_;
};

/// A camera that a host places.
SceneCamera cameraOf(const seaway_shm_picture_request& asked) {
  SceneCamera camera;
  camera.name = "of a host";
  camera.place = CameraPlace{asked.latitude_deg, asked.longitude_deg, asked.eye_height};
  camera.yaw_deg = asked.heading_deg;
  camera.pitch_deg = asked.pitch_deg;
  camera.roll_deg = asked.roll_deg;
  camera.fieldOfView_deg = asked.vertical_field_deg;
  return camera;
}

shm::Picture draw(FrameMaker& frames, const seaway_shm_picture_request& asked) {
  FrameRequest request;
  request.camera = asked.camera;
  if ((asked.flags & SEAWAY_SHM_OWN_CAMERA) != 0) request.own = cameraOf(asked);
  request.t = asked.time;
  request.size = {static_cast<int>(asked.width), static_cast<int>(asked.height)};
  try {
    const auto frame = frames.draw(request);
    const glm::ivec2 size = frame->colour.size;
    return {static_cast<std::uint32_t>(size.x), static_cast<std::uint32_t>(size.y),
            frame->colour.rgb, frame->depth.metres, frame};
  } catch (const InputError& fault) {
    throw shm::Refused(SEAWAY_SHM_BAD_VALUE, fault.what());
  }
}

/// The endpoint with what it counts, told at the end.
class ShmServiceEndpoint : public Endpoint {
 public:
  ShmServiceEndpoint(shm::ShmOptions options, Meter& meter) : meter_(meter), observer_(meter) {
    options.backing.observer = &observer_;
    endpoint_ = std::make_unique<shm::ShmEndpoint>(std::move(options));
  }
  std::string description() const override { return endpoint_->description(); }
  void start() override { endpoint_->start(); }
  void stop() override {
    endpoint_->stop();
    const MeterCounts counts = meter_.read();
    std::uint64_t refused = 0;
    for (const std::uint64_t each : counts.refusals) refused += each;
    spdlog::info("{} ends: requests={} points={} frames={} refused={}", description(),
                 counts.requests.total(), counts.points, counts.frames.total(), refused);
  }

 private:
  Meter& meter_;
  MeterObserver observer_;
  std::unique_ptr<shm::ShmEndpoint> endpoint_;
};

}  // namespace

void addShmOptions(CLI::App& command, ShmServiceOptions& options) {
  const char* group = "Shared memory";
  command
      .add_option("--shm", options.name,
                  "NAME to serve hosts of this machine under, through sim_bridge/shm/seaway_shm.h")
      ->group(group);
  command.add_option("--shm-hosts", options.hosts, "hosts that may be connected at once")
      ->capture_default_str()
      ->group(group);
  command.add_option("--shm-points", options.points, "points of a request, at most")
      ->capture_default_str()
      ->group(group);
}

std::unique_ptr<Endpoint> makeShmEndpoint(const ShmServiceOptions& options, ServedSea& sea,
                                          const ServeClock& clock, FrameMaker& frames) {
  if (options.hosts < 1 || options.hosts > 256) {
    throw InputError("--shm-hosts: " + std::to_string(options.hosts) +
                     " is not allowed; must be in [1, 256]");
  }
  if (options.points < 1 || options.points > 1048576) {
    throw InputError("--shm-points: " + std::to_string(options.points) +
                     " is not allowed; must be in [1, 1048576]");
  }
  if (options.name.empty()) return nullptr;
  shm::ShmOptions made;
  made.name = options.name;
  made.segment.slots = static_cast<std::uint32_t>(options.hosts);
  made.segment.points = static_cast<std::uint32_t>(options.points);
  made.backing.newHost = [&sea] { return std::make_unique<shm::SeaHost>(sea); };
  made.backing.draw = [&frames](const seaway_shm_picture_request& asked) {
    return draw(frames, asked);
  };
  if (!clock.isHosts()) {
    made.backing.now = [clock]() -> std::optional<double> { return clock.now(); };
  }
  return std::make_unique<ShmServiceEndpoint>(std::move(made), sea.meters().of("shm"));
}

}  // namespace seaway::bridge
