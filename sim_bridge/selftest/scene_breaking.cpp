#include <functional>

#include "sim_bridge/selftest/scene_generator.h"

// What no reader of scenes may accept.
namespace seaway::bridge {
namespace {

using Json = nlohmann::ordered_json;

const KeyDescription* descriptionOf(const std::vector<KeyDescription>& keys,
                                    const std::string& name) {
  for (const KeyDescription& key : keys) {
    if (key.key == name) return &key;
  }
  return nullptr;
}

/// A value that `key` does not allow.
Json wrongValue(const KeyDescription& key, std::size_t which) {
  const bool isStructured = !key.children.empty() || key.components > 0;
  if (isStructured) return which % 2 == 0 ? Json("soon") : Json(12);
  if (!key.words.empty()) return which % 2 == 0 ? Json("sideways") : Json::array({"auto"});
  if (!key.range) return Json::array({1, 2});
  const Range& range = *key.range;
  switch (which % 5) {
    case 0:
      return "soon";
    case 1:
      return ".nan";
    case 2:
      return Json::array({1, 2});
    case 3:
      if (std::isfinite(range.most) && !range.infinityAllowed)
        return 10.0 * std::abs(range.most) + 1.0;
      return "-.inf";
    default:
      if (std::isfinite(range.least)) return range.least - 1.0;
      return Json::object();
  }
}

}  // namespace

void SceneGenerator::gather(Json& mapping, const std::vector<KeyDescription>& keys, bool exactlyOne,
                            std::vector<Place>& places) {
  places.push_back({&mapping, &keys, exactlyOne});
  for (auto& [name, child] : mapping.items()) {
    const KeyDescription* key = descriptionOf(keys, name);
    if (!key || key->children.empty()) continue;
    const bool oneOf = key->type == "mapping with one of these keys";
    if (child.is_object()) gather(child, key->children, oneOf, places);
    if (!child.is_array()) continue;
    for (Json& item : child) {
      if (item.is_object()) gather(item, key->children, false, places);
    }
  }
}

std::string SceneGenerator::breakOne(Json& scene) {
  std::vector<Place> places;
  gather(scene, keys_, false, places);
  for (;;) {
    const Place place = places[below(places.size())];
    const std::size_t kind = below(4);
    if (kind == 0) {
      (*place.mapping)["nonsense"] = 1;
      return "a key that there is not";
    }
    if (place.mapping->empty()) continue;
    auto entry = place.mapping->begin();
    std::advance(entry, below(place.mapping->size()));
    const KeyDescription* key = descriptionOf(*place.keys, entry.key());
    if (kind == 1) {
      if (!place.exactlyOne && key->need != Need::required) continue;
      const std::string name = key->key;
      place.mapping->erase(name);
      return "without " + name;
    }
    const std::string name = key->key;
    (*place.mapping)[name] = wrongValue(*key, below(10));
    return "a wrong value of " + name;
  }
}

}  // namespace seaway::bridge
