#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

#include "sim_bridge/scene/schema.h"

namespace seaway::bridge {

/// Scenes at random, by the very tables that scene files are read by: a key that is added there is
/// tried here.
///
/// Every key is given or left out, numbers are drawn from all of their range, its ends included,
/// words from all that are allowed, and texts, which name files, from those that the given scenes
/// have at the same key. What decides how long a command takes (pixels, seconds, vertices, octaves)
/// is kept small. The same seed gives the same scenes.
class SceneGenerator {
 public:
  using Json = nlohmann::ordered_json;

  /// `examples` are scene files that can be read; their relative paths become absolute.
  SceneGenerator(std::uint64_t seed, const std::vector<std::filesystem::path>& examples);

  /// A scene as the tables allow: what they cannot say (a mount that is no vessel, say) may be
  /// wrong with it all the same.
  Json scene();

  /// Breaks one thing of a scene so that no reader may accept it, and says what.
  std::string breakOne(Json& scene);

  /// In [0, 1).
  double uniform() { return static_cast<double>(random_() >> 11) * 0x1p-53; }
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(random_() % count); }
  bool chance(double probability) { return uniform() < probability; }

 private:
  struct Place {
    Json* mapping;
    const std::vector<KeyDescription>* keys;
    bool exactlyOne;
  };
  void learn(const Json& value, const std::string& path);
  Json mapping(const std::vector<KeyDescription>& keys, bool exactlyOne, const std::string& path);
  Json value(const KeyDescription& key, const std::string& path);
  Json number(const KeyDescription& key, const std::string& path);
  Json list(const KeyDescription& key, const std::string& path);
  double drawn(const Range& range);
  bool canBeGiven(const KeyDescription& key, const std::string& path) const;
  void placeNear(Json& scene);
  void mountCameras(Json& scene);
  void gather(Json& mapping, const std::vector<KeyDescription>& keys, bool exactlyOne,
              std::vector<Place>& places);

  std::mt19937_64 random_;
  std::vector<KeyDescription> keys_;
  std::map<std::string, std::vector<Json>> examples_;  // by path, `list[]` for items
};

}  // namespace seaway::bridge
