#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "sim_bridge/capi/coupled_sea.h"
#include "sim_bridge/commands/blocked_octaves_json.h"

namespace seaway::bridge {
namespace {

using Json = nlohmann::ordered_json;

// JSON has no infinity: null.
Json number(double value) { return std::isfinite(value) ? Json(value) : Json(); }

const char* kindName(OctaveKind kind) {
  switch (kind) {
    case OctaveKind::perlin:
      return "perlin";
    case OctaveKind::group:
      return "group";
    case OctaveKind::regular:
      return "regular";
  }
  return "";
}

Json octavesJson(const WaveField& waves) {
  Json list = Json::array();
  for (const Octave& octave : waves.octaves()) {
    list.push_back({{"kind", kindName(octave.kind)},
                    {"standard_deviation_m", octave.standardDeviation},
                    {"wavelength_m", dominantWavelength(octave)}});
  }
  return list;
}

Json seaJson(const Scene& scene, const Sea& sea, double hm0Realised) {
  const WaveFieldSettings& settings = sea.surface.waves().settings();
  return {{"hm0_asked_m", sea.hm0Asked},
          {"hm0_realised_m", hm0Realised},
          {"depth_m", number(settings.depth)},
          {"water_level_m", scene.sea.waterLevel},
          {"geoid", sea.level.hasGeoid()},
          {"current_east_m_s", settings.current.x},
          {"current_north_m_s", settings.current.y},
          {"seed", scene.sea.seed},
          {"octaves", octavesJson(sea.surface.waves())},
          {"blocked_octaves", asJson(sea.blocked)}};
}

Json vesselsJson(const Scene& scene, const CoupledSea::Moment& moment) {
  Json list = Json::array();
  for (std::size_t i = 0; i < scene.vessels.size(); ++i) {
    const VesselPose& pose = moment.poses[i];
    list.push_back({{"name", scene.vessels[i].name},
                    {"model", scene.vessels[i].modelPath},
                    {"length_m", scene.vessels[i].model.hull.length},
                    {"beam_m", scene.vessels[i].model.hull.beam},
                    {"mass_kg", scene.vessels[i].model.hull.mass()},
                    {"east_m", pose.position.x},
                    {"north_m", pose.position.y},
                    {"height_m", pose.height}});
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

/// Steps and pictures tell of different effects, some of the same: who says "on" is heard.
Json effectsJson(const std::vector<EffectReport>& step, const std::vector<EffectReport>& frame) {
  Json list = Json::array();
  for (std::size_t i = 0; i < effectDescriptions().size(); ++i) {
    EffectReport none;
    none.reason = "no step and no picture yet";
    const EffectReport& ofStep = i < step.size() ? step[i] : none;
    const EffectReport& ofFrame = i < frame.size() ? frame[i] : none;
    const bool frameSpeaks = ofFrame.state == EffectState::on || i >= step.size();
    const EffectReport& chosen = frameSpeaks && ofStep.state != EffectState::on ? ofFrame : ofStep;
    list.push_back({{"name", effectDescriptions()[i].name},
                    {"state", effectStateName(chosen.state)},
                    {"reason", chosen.reason},
                    {"memory_bytes", std::max(ofStep.memoryBytes, ofFrame.memoryBytes)},
                    {"step_us", ofStep.costMicroseconds},
                    {"frame_us", ofFrame.costMicroseconds}});
  }
  return list;
}

}  // namespace

std::string CoupledSea::description() const {
  const std::lock_guard lock(changing_);
  if (hm0Realised_ < 0.0) hm0Realised_ = realisedSignificantWaveHeight(sea_.surface);
  const std::shared_ptr<const Moment> moment = now();
  const Json description{{"version", SEAWAY_VERSION},
                         {"scene", scene_.file.string()},
                         {"time_s", moment->time},
                         {"step_s", scene_.run.step},
                         {"anchor",
                          {{"latitude_deg", scene_.sea.anchor.latitude_deg},
                           {"longitude_deg", scene_.sea.anchor.longitude_deg}}},
                         {"sea", seaJson(scene_, sea_, hm0Realised_)},
                         {"vessels", vesselsJson(scene_, *moment)},
                         {"cameras", camerasJson(scene_)},
                         {"effects", effectsJson(stepEffects_, frameEffects_)}};
  return description.dump(2, ' ', false, Json::error_handler_t::replace);
}

}  // namespace seaway::bridge
