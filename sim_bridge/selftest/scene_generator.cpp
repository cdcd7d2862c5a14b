#include "sim_bridge/selftest/scene_generator.h"

#include <algorithm>
#include <cmath>

#include "sim_bridge/scene/scene_loader.h"
#include "sim_bridge/selftest/yaml_json.h"

namespace seaway::bridge {
namespace {

using Json = nlohmann::ordered_json;

/// Numbers that decide how long a command takes, or that hardly any sea has beyond these, by the
/// ends of their paths.
struct Frugal {
  const char* path;
  Range range;
};
const Frugal frugal[] = {
    {"run.size", Range::within(1, 96)},
    {"run.duration_s", Range::within(0.01, 0.6)},
    {"run.fps", Range::within(0.0, 4.0)},
    {"run.step_s", Range::within(0.01, 1.0)},
    {"accuracy.grid", Range::within(2, 64)},
    {"wakes.cell_m", Range::within(0.5, 100.0)},
    {"wakes.window_m", Range::within(0.0, 2e3)},
    {"layers.cell_m", Range::within(0.25, 20.0)},
    {".octaves", Range::within(1, 6)},
    {"foam_radius_m", Range::within(0.0, 20.0)},
    {"layers[].radius_m", Range::within(0.1, 50.0)},
    {".hm0_m", Range::within(0.001, 20.0)},
    {".tp_s", Range::within(0.5, 30.0)},
    {".wind_m_s", Range::within(1.0, 40.0)},
    {"intrinsics.size", Range::within(1, 4096)},
    {"terrain.size_m", Range::within(1e2, 2e4)},
    {"terrain.height_m", Range::within(-100.0, 300.0)},
    {".width_hz", Range::within(0.002, 0.01)},
};

/// Keys that only go with others, in ways that the tables do not tell: never given.
const char* const leftOut[] = {"sea.state.octaves",
                               "ochi_hubble.swell",
                               "ochi_hubble.wind_sea",
                               ".spread_wind_m_s",
                               ".spread",
                               "pierson_moskowitz.wind_m_s",
                               "layers[].file",
                               "layers[].grid",
                               "terrain.extent",
                               "terrain.no_data_m",
                               "scenery[].file",
                               "ripples[].side_m",
                               "ripples[].period_s",
                               "ripples[].wavelength_m"};
/// And those that are always wanted where their mapping is.
const char* const always[] = {
    "pierson_moskowitz.hm0_m", "pierson_moskowitz.tp_s", "ochi_hubble.hm0_m", "intrinsics.fx_px",
    "intrinsics.fy_px",        "intrinsics.cx_px",       "intrinsics.cy_px",  "intrinsics.size",
    "layers[].place",          "terrain.centre",         "terrain.size_m",    "terrain.height_m"};

template <std::size_t count>
bool isAmong(const std::string& path, const char* const (&ends)[count]) {
  return std::any_of(std::begin(ends), std::end(ends),
                     [&](const char* end) { return path.ends_with(end); });
}

constexpr std::size_t mostItems = 2;

bool isOneOf(const KeyDescription& key) { return key.type == "mapping with one of these keys"; }
bool isList(const KeyDescription& key) { return key.type == "list of mappings"; }
bool isMapping(const KeyDescription& key) { return key.type == "mapping" || isOneOf(key); }
bool isWhole(const KeyDescription& key) {
  return key.type == "integer" || key.type.find("whole numbers") != std::string::npos;
}

}  // namespace

SceneGenerator::SceneGenerator(std::uint64_t seed,
                               const std::vector<std::filesystem::path>& examples)
    : random_(seed), keys_(sceneSchema().describe()) {
  for (const std::filesystem::path& file : examples) {
    Json example = jsonFromYaml(readYaml(file));
    makePathsAbsolute(example, std::filesystem::absolute(file).parent_path());
    learn(example, "");
  }
}

void SceneGenerator::learn(const Json& value, const std::string& path) {
  if (value.is_object()) {
    for (const auto& [key, child] : value.items()) {
      learn(child, path.empty() ? key : path + "." + key);
    }
  } else if (value.is_array() && !value.empty() && value[0].is_object()) {
    for (const Json& item : value) learn(item, path + "[]");
  } else {
    examples_[path].push_back(value);
  }
}

double SceneGenerator::drawn(const Range& range) {
  const double inset = 1e-6;
  const double low = std::isfinite(range.least) ? range.least : -1e6;
  const double high = std::isfinite(range.most) ? range.most : 1e6;
  if (chance(0.1)) return range.leastIncluded && std::isfinite(range.least) ? low : low + inset;
  if (chance(0.1)) return range.mostIncluded && std::isfinite(range.most) ? high : high - inset;
  // Of any size: half of them evenly, half evenly in their logarithm.
  double number = low + uniform() * (high - low);
  if (chance(0.5)) {
    const double sign = low < 0.0 && (high <= 0.0 || chance(0.5)) ? -1.0 : 1.0;
    number = sign * std::pow(10.0, -3.0 + 6.0 * uniform());
  }
  return range.holds(std::clamp(number, low, high)) ? std::clamp(number, low, high)
                                                    : 0.5 * (low + high);
}

Json SceneGenerator::number(const KeyDescription& key, const std::string& path) {
  Range range = key.range.value_or(Range::any());
  bool kept = false;
  for (const Frugal& limit : frugal) {
    if (!path.ends_with(limit.path)) continue;
    kept = true;
    range.least = std::max(range.least, limit.range.least);
    range.most = std::min(range.most, limit.range.most);
    range.mostIncluded = range.leastIncluded = true;
  }
  const auto one = [&]() -> Json {
    const auto known = examples_.find(path);
    if (!kept && key.components == 0 && known != examples_.end() && chance(0.4)) {
      return known->second[below(known->second.size())];
    }
    const double number = drawn(range);
    if (!isWhole(key)) return number;
    return static_cast<std::int64_t>(std::clamp(std::round(number), -9e15, 9e15));
  };
  if (key.components == 0) return one();
  Json list = Json::array();
  for (int i = 0; i < key.components; ++i) list.push_back(one());
  return list;
}

Json SceneGenerator::list(const KeyDescription& key, const std::string& path) {
  Json items = Json::array();
  const std::size_t count = 1 + below(mostItems);
  for (std::size_t i = 0; i < count; ++i) {
    items.push_back(mapping(key.children, false, path + "[]"));
    if (items.back().contains("name")) items.back()["name"] = key.key + "_" + std::to_string(i);
  }
  return items;
}

Json SceneGenerator::value(const KeyDescription& key, const std::string& path) {
  if (isList(key)) return list(key, path);
  if (isMapping(key)) return mapping(key.children, isOneOf(key), path);
  if (!key.words.empty()) return key.words[below(key.words.size())];
  if (key.range) return number(key, path);
  if (key.type == "name") return "name";
  const std::vector<Json>& known = examples_.at(path);
  return known[below(known.size())];
}

bool SceneGenerator::canBeGiven(const KeyDescription& key, const std::string& path) const {
  if (isAmong(path, leftOut)) return false;
  if (isList(key) || isMapping(key)) {
    const std::string inner = isList(key) ? path + "[]." : path + ".";
    return std::all_of(key.children.begin(), key.children.end(), [&](const KeyDescription& child) {
      return child.need == Need::optional || canBeGiven(child, inner + child.key);
    });
  }
  return !key.words.empty() || key.range || key.type == "name" || examples_.contains(path);
}

Json SceneGenerator::mapping(const std::vector<KeyDescription>& keys, bool exactlyOne,
                             const std::string& path) {
  const auto pathOf = [&](const KeyDescription& key) {
    return path.empty() ? key.key : path + "." + key.key;
  };
  std::vector<const KeyDescription*> possible;
  for (const KeyDescription& key : keys) {
    if (canBeGiven(key, pathOf(key))) possible.push_back(&key);
  }
  Json mapping = Json::object();
  if (exactlyOne) {
    const KeyDescription& key = *possible[below(possible.size())];
    mapping[key.key] = value(key, pathOf(key));
    return mapping;
  }
  const double share = 0.15 + 0.5 * uniform();
  for (const KeyDescription* key : possible) {
    const bool wanted = key->need == Need::required || isAmong(pathOf(*key), always);
    if (wanted || chance(share)) mapping[key->key] = value(*key, pathOf(*key));
  }
  return mapping;
}

// What the tables cannot say: that places lie near the anchor.
void SceneGenerator::placeNear(Json& scene) {
  const Json anchor = scene["sea"]["anchor"];
  const double latitude = anchor["latitude_deg"], longitude = anchor["longitude_deg"];
  const std::function<void(Json&)> visit = [&](Json& node) {
    if (node.is_object() && node.contains("latitude_deg") && node.contains("longitude_deg")) {
      const double spread = chance(0.05) ? 10.0 : 0.01;
      const auto near = [&](double middle, double least, double most) {
        return std::clamp(middle + spread * (uniform() - 0.5), least, most);
      };
      node["latitude_deg"] = near(latitude, -90.0, 90.0);
      node["longitude_deg"] = near(longitude, -180.0, 360.0);
    }
    if (!node.is_structured()) return;
    for (Json& child : node) visit(child);
  };
  for (auto& [key, part] : scene.items()) {
    if (key != "sea") visit(part);
  }
}

// Nor that a camera has a mount or a place.
void SceneGenerator::mountCameras(Json& scene) {
  if (!scene.contains("cameras")) return;
  for (Json& camera : scene["cameras"]) {
    const bool afloat = scene.contains("vessels") && (!camera.contains("place") || chance(0.5));
    if (afloat) {
      camera["mount"] = scene["vessels"][below(scene["vessels"].size())]["name"];
      camera.erase("place");
      continue;
    }
    camera.erase("mount");
    camera.erase("stabilised");
    camera.erase("position_m");
    if (!camera.contains("place")) {
      camera["place"] = scene["sea"]["anchor"];
      camera["place"]["height_m"] = drawn(Range::within(-20.0, 2000.0));
    }
  }
}

Json SceneGenerator::scene() {
  Json scene = mapping(keys_, false, "");
  if (!scene.contains("run")) scene["run"] = Json::object();
  for (const KeyDescription& key : keys_) {
    if (key.key != "run" && key.key != "accuracy") continue;
    // Their defaults are meant for real work.
    for (const KeyDescription& child : key.children) {
      const std::string path = key.key + "." + child.key;
      const bool costs = std::any_of(std::begin(frugal), std::end(frugal),
                                     [&](const Frugal& limit) { return path == limit.path; });
      if (costs && !scene[key.key].contains(child.key)) {
        scene[key.key][child.key] = value(child, path);
      }
    }
  }
  placeNear(scene);
  mountCameras(scene);
  return scene;
}

}  // namespace seaway::bridge
