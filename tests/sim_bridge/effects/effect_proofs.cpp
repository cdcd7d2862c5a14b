#include "tests/sim_bridge/effects/effect_proofs.h"

#include <algorithm>
#include <fstream>
#include <string>

#include "sim_bridge/selftest/yaml_json.h"

namespace seaway::bridge::test {
namespace {

constexpr const char* base = R"(
sea:
  anchor: {latitude_deg: 54.32, longitude_deg: 10.15}
  depth_m: 12
  seed: 5
  state:
    octaves:
      - {kind: group, standard_deviation_m: 0.04, frequency_hz: 0.42, bandwidth_hz: 0.06, directional_width_deg: 30, toward_deg: 70}
      - {kind: group, standard_deviation_m: 0.02, frequency_hz: 0.6, bandwidth_hz: 0.1, directional_width_deg: 40, toward_deg: 60}
      - {kind: group, standard_deviation_m: 0.01, frequency_hz: 0.9, bandwidth_hz: 0.15, directional_width_deg: 50, toward_deg: 85}
cameras:
  - {name: eye, place: {latitude_deg: 54.31985, longitude_deg: 10.14992, height_m: 3}, yaw_deg: 17, pitch_deg: -10}
light: {sun: {elevation_deg: 35, azimuth_deg: 150}, wind: {speed_m_s: 2}}
accuracy: {grid: [16, 16], wakes: {cell_m: 2, window_m: 128}}
run: {duration_s: 10, fps: 1, step_s: 0.1, size: [32, 18]}
)";

#define SEAWAY_BOAT(model, latitude, more)                                                   \
  "{vessels: [{name: launch, model: VESSELS/" model ".yaml, start: {latitude_deg: " latitude \
  ", longitude_deg: 10.15, heading_deg: 300}" more "}]"

constexpr const char *boat = SEAWAY_BOAT("launch_12m", "54.32", "") "}",
                     *sailing = SEAWAY_BOAT("launch_12m", "54.32", ", speed_m_s: 4") "}",
                     *behind = SEAWAY_BOAT("launch_12m", "54.3180", "") "}",
                     *openBoat = SEAWAY_BOAT("open_launch_12m", "54.32", "") "}",
                     *openBehind = SEAWAY_BOAT("open_launch_12m", "54.3180", "") "}",
                     *unmirroredBehind = SEAWAY_BOAT(
                         "launch_12m", "54.3180",
                         "") ", effects: {reflection: off, refraction: off, shadows: off}}",
                     *nothing = "{}";

#define SEAWAY_EYE(height, pitch)                                                   \
  "cameras: [{name: eye, place: {latitude_deg: 54.31985, longitude_deg: 10.14992, " \
  "height_m: " height "}, yaw_deg: 17, pitch_deg: " pitch "}]"
#define SEAWAY_AHEAD "place: {latitude_deg: 54.31998, longitude_deg: 10.15}"
#define SEAWAY_AFTER "place: {latitude_deg: 54.3180, longitude_deg: 10.15}"
#define SEAWAY_NIGHT "sun: {elevation_deg: -24, azimuth_deg: 330}"
#define SEAWAY_MOON "moon: {elevation_deg: 17, azimuth_deg: 14, phase: 0.45}"
#define SEAWAY_LAMP "lights: [{name: quay, place: {latitude_deg: 54.3206, longitude_deg: 10.15}}]"
#define SEAWAY_MAP(latitude)                                    \
  "{file: TERRAIN/island.png, centre: {latitude_deg: " latitude \
  ", longitude_deg: 10.15}, size_m: [1200, 1200], height_m: [-40, 120], datum: still_water}"
#define SEAWAY_ISLAND(latitude) "{terrain: " SEAWAY_MAP(latitude) "}"

const EffectProof proofs[] = {
    {Effect::waves, boat,
     SEAWAY_BOAT("launch_12m", "54.32", "") ", sea: {state: {octaves: gone, calm: {}}}}",
     SEAWAY_BOAT("launch_12m", "54.32", "") ", sea: {state: {octaves: gone, calm: {}}}}"},
    {Effect::vesselMotion, boat, nothing},
    {Effect::hullLoads, SEAWAY_BOAT("launch_driven_12m", "54.32", ", motion: free") "}",
     SEAWAY_BOAT("launch_driven_12m", "54.32", "") "}",
     SEAWAY_BOAT("launch_driven_12m", "54.32", "") "}"},
    {Effect::water, nothing, "{" SEAWAY_EYE("3", "60") "}"},
    {Effect::sky, nothing, "{effects: {water: off}, " SEAWAY_EYE("3", "-60") "}", nullptr, nothing},
    {Effect::sun, nothing, "{light: {" SEAWAY_NIGHT "}}"},
    {Effect::vesselMeshes, boat, unmirroredBehind},
    {Effect::wake, sailing, boat},
    {Effect::foam, "{light: {wind: {speed_m_s: 12}}}", nothing, nullptr,
     "{light: {wind: {speed_m_s: 0}}}"},
    {Effect::trail, sailing, boat},
    {Effect::oil, "{layers: [{kind: oil, " SEAWAY_AHEAD ", radius_m: 6}]}",
     "{layers: [{kind: oil, " SEAWAY_AHEAD ", radius_m: 6, time_s: 1000}]}", nothing},
    {Effect::splash, "{splashes: [{" SEAWAY_AHEAD ", time_s: 0.5}]}",
     "{splashes: [{" SEAWAY_AHEAD ", time_s: 1000}]}", nothing},
    {Effect::rain, "{rain: {rate_mm_h: 8}}", "{rain: {rate_mm_h: 8, from_s: 1000}}", nothing},
    {Effect::ripples, "{ripples: [{" SEAWAY_AHEAD "}]}",
     "{ripples: [{" SEAWAY_AHEAD ", time_s: 1000}]}", nothing},
    {Effect::outline, "{sea: {outline: FOLDER/pool.geojson}}", nothing, nothing},
    {Effect::hullMask, openBoat, openBehind},
    {Effect::reflection, boat, behind},
    {Effect::refraction, boat, behind},
    {Effect::underWater, "{" SEAWAY_EYE("-2", "-10") "}", nothing},
    {Effect::haze, nothing, "{" SEAWAY_EYE("3", "60") "}"},
    {Effect::shadows, boat, behind},
    {Effect::scenery, "{scenery: [{name: pier, mesh: SCENERY/pier.obj, " SEAWAY_AHEAD "}]}",
     "{scenery: [{name: pier, mesh: SCENERY/pier.obj, " SEAWAY_AFTER
     "}], effects: {reflection: off, refraction: off, shadows: off}}",
     nothing},
    {Effect::terrain, SEAWAY_ISLAND("54.3245"), SEAWAY_ISLAND("54.29"), nothing},
    {Effect::lights, "{" SEAWAY_LAMP ", light: {" SEAWAY_NIGHT "}}", "{" SEAWAY_LAMP "}",
     "{light: {" SEAWAY_NIGHT "}}", nothing},
    {Effect::moon, "{light: {" SEAWAY_NIGHT ", " SEAWAY_MOON "}}", "{light: {" SEAWAY_MOON "}}",
     "{light: {" SEAWAY_NIGHT "}}"},
};

std::string replaced(std::string text, const std::string& word, const std::string& by) {
  for (std::size_t at = text.find(word); at != text.npos; at = text.find(word, at + by.size())) {
    text.replace(at, word.size(), by);
  }
  return text;
}

/// A shore about the camera and what it sees.
void writeOutline(const std::filesystem::path& file) {
  std::ofstream(file) << R"({"type": "Polygon", "coordinates": [[[10.148, 54.319], [10.152, 54.319],
    [10.152, 54.3203], [10.148, 54.3203], [10.148, 54.319]]]})";
}

Json jsonOf(const char* text, const std::filesystem::path& folder) {
  const std::string configs = SEAWAY_SOURCE_DIR "/configs/";
  std::string yaml = replaced(text, "VESSELS", configs + "vessels");
  yaml = replaced(replaced(yaml, "TERRAIN", configs + "terrain"), "SCENERY", configs + "scenery");
  yaml = replaced(yaml, "FOLDER", folder.string());
  return jsonFromYaml(parseYaml(yaml, "proof.yaml"));
}

/// What is "gone" goes.
void merge(Json& scene, const Json& difference) {
  for (const auto& [key, value] : difference.items()) {
    if (value == "gone") {
      scene.erase(key);
    } else if (value.is_object() && scene.contains(key)) {
      merge(scene[key], value);
    } else {
      scene[key] = value;
    }
  }
}

}  // namespace

std::optional<EffectProof> proofOf(Effect effect) {
  const auto found = std::find_if(std::begin(proofs), std::end(proofs),
                                  [&](const EffectProof& proof) { return proof.effect == effect; });
  if (found == std::end(proofs)) return std::nullopt;
  return *found;
}

Json sceneOf(Effect effect, const char* difference, const char* setting,
             const std::filesystem::path& folder) {
  writeOutline(folder / "pool.geojson");
  Json scene = jsonOf(base, folder);
  merge(scene, jsonOf(difference, folder));
  scene["effects"][std::string(effectName(effect))] = setting;
  return scene;
}

}  // namespace seaway::bridge::test
