#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

#include <cmath>
#include <filesystem>
#include <mutex>

#include "sim_bridge/capi/handles.h"
#include "sim_bridge/scene/scene_loader.h"

namespace seaway::bridge::capi {
namespace {

constexpr seaway_sea_options seaDefaults{sizeof(seaway_sea_options), 0, 0.0};

/// A host's standard output is its own: where nobody has set spdlog's logger, it goes elsewhere.
void logToStandardError() {
  static std::once_flag once;
  std::call_once(once, [] {
    if (!spdlog::default_logger() || !spdlog::default_logger()->name().empty()) return;
    const auto logger = std::make_shared<spdlog::logger>(
        "seaway", std::make_shared<spdlog::sinks::stderr_sink_mt>());
    logger->set_pattern("seaway: %l: %v");
    spdlog::set_default_logger(logger);
  });
}

void requireSceneTime(double t, const char* name) {
  requireThat(t >= 0.0 && t <= 1e7,
              std::string(name) + " is " + numberText(t) + " s; must be in [0, 1e7]");
}

template <class Load>
seaway_status make(const seaway_sea_options* given, seaway_sea** out, const Load& load) {
  if (out) *out = nullptr;
  return guarded([&] {
    require(out, "sea");
    const seaway_sea_options options = optionsOr(given, seaDefaults, "options");
    requireSceneTime(options.start_time, "options.start_time");
    logToStandardError();
    *out = reinterpret_cast<seaway_sea*>(new CoupledSea(load(), options.start_time));
  });
}

}  // namespace
}  // namespace seaway::bridge::capi

using namespace seaway::bridge;
using namespace seaway::bridge::capi;

extern "C" {

void seaway_sea_options_init(seaway_sea_options* options, size_t size) {
  initialise(options, size, seaDefaults);
}

seaway_status seaway_sea_from_file(const char* path, const seaway_sea_options* options,
                                   seaway_sea** sea) {
  return make(options, sea, [&] {
    require(path, "path");
    return loadScene(path);
  });
}

seaway_status seaway_sea_from_text(const char* yaml, const char* folder,
                                   const seaway_sea_options* options, seaway_sea** sea) {
  return make(options, sea, [&] {
    require(yaml, "yaml");
    return sceneFromText(yaml, folder ? folder : ".");
  });
}

void seaway_sea_destroy(seaway_sea* sea) { delete reinterpret_cast<CoupledSea*>(sea); }

double seaway_sea_time(const seaway_sea* sea) { return sea ? seaOf(sea).now()->time : NAN; }

double seaway_sea_step_length(const seaway_sea* sea) {
  return sea ? seaOf(sea).scene().run.step : NAN;
}

seaway_status seaway_sea_step(seaway_sea* sea) {
  return guarded([&] { seaOf(sea).step(); });
}

seaway_status seaway_sea_step_to(seaway_sea* sea, double time) {
  return guarded([&] {
    CoupledSea& stepped = seaOf(sea);
    requireThat(std::isfinite(time) && time <= 1e7,
                "time is " + numberText(time) + " s; must be finite and at most 1e7");
    stepped.stepTo(time);
  });
}

seaway_status seaway_sea_restart(seaway_sea* sea, double time) {
  return guarded([&] {
    CoupledSea& restarted = seaOf(sea);
    requireSceneTime(time, "time");
    restarted.restart(time);
  });
}

seaway_status seaway_sea_listen(seaway_sea* sea, size_t count, const seaway_listener* listeners) {
  return guarded([&] {
    CoupledSea& heard = seaOf(sea);
    if (count > 0) require(listeners, "listeners");
    std::vector<seaway::WakeListener> places;
    for (size_t i = 0; i < count; ++i) {
      const seaway_listener& given = listeners[i];
      const bool sound =
          std::isfinite(given.east + given.north + given.radius) && given.radius >= 0.0;
      requireThat(sound, [&] {
        return "listeners[" + std::to_string(i) +
               "]: east, north and radius must be finite, radius >= 0";
      });
      places.push_back({{given.east, given.north}, given.radius, 0});
    }
    heard.listen(std::move(places));
  });
}

seaway_status seaway_sea_describe(const seaway_sea* sea, char* buffer, size_t size,
                                  size_t* needed) {
  return guarded([&] {
    const CoupledSea& described = seaOf(sea);
    if (size > 0) require(buffer, "buffer");
    const std::string text = described.description();
    if (needed) *needed = text.size() + 1;
    if (size < text.size() + 1) {
      throw CallError(SEAWAY_BUFFER_TOO_SMALL, "buffer has " + std::to_string(size) +
                                                   " bytes; needed are " +
                                                   std::to_string(text.size() + 1));
    }
    std::memcpy(buffer, text.c_str(), text.size() + 1);
  });
}

}  // extern "C"
