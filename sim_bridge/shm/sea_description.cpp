#include <cmath>
#include <nlohmann/json.hpp>

#include "sim_bridge/shm/sea_host.h"

namespace seaway::bridge::shm {
namespace {

using Json = nlohmann::ordered_json;

// JSON has no infinity: null.
Json number(double value) { return std::isfinite(value) ? Json(value) : Json(); }

Json vesselsJson(const Scene& scene) {
  Json list = Json::array();
  for (const SceneVessel& vessel : scene.vessels) {
    list.push_back({{"name", vessel.name},
                    {"length_m", vessel.model.hull.length},
                    {"beam_m", vessel.model.hull.beam},
                    {"makes_waves", vessel.model.wake.strength > 0.0}});
  }
  return list;
}

Json camerasJson(const Scene& scene) {
  Json list = Json::array();
  for (const SceneCamera& camera : scene.cameras) {
    list.push_back({{"name", camera.name},
                    {"mount", camera.mount.empty() ? Json() : Json(camera.mount)},
                    {"fov_deg", camera.fieldOfView_deg}});
  }
  return list;
}

Json wakesJson(const ServedSea& sea) {
  const auto span = sea.wakeSpan();
  return span ? Json{{"from_s", span->first}, {"to_s", span->second}} : Json();
}

}  // namespace

std::string describeSea(const ServedSea& sea) {
  const auto scene = sea.scene();
  const auto surface = sea.surface();
  const WaveFieldSettings& settings = surface->waves().settings();
  const Json description{{"scene", scene->file.string()},
                         {"anchor",
                          {{"latitude_deg", scene->sea.anchor.latitude_deg},
                           {"longitude_deg", scene->sea.anchor.longitude_deg}}},
                         {"sea",
                          {{"hm0_m", surface->waves().significantWaveHeight()},
                           {"octaves", surface->waves().octaves().size()},
                           {"depth_m", number(settings.depth)},
                           {"water_level_m", scene->sea.waterLevel},
                           {"current_east_m_s", settings.current.x},
                           {"current_north_m_s", settings.current.y}}},
                         {"vessels", vesselsJson(*scene)},
                         {"cameras", camerasJson(*scene)},
                         {"picture", {{"width", scene->run.size.x}, {"height", scene->run.size.y}}},
                         {"wakes", wakesJson(sea)}};
  return description.dump(2, ' ', false, Json::error_handler_t::replace);
}

}  // namespace seaway::bridge::shm
