#include "sim_bridge/selftest/random_case.h"

#include <spdlog/fmt/fmt.h>

#include "sim_bridge/selftest/scene_generator.h"

namespace seaway::bridge {
namespace {

using Json = nlohmann::ordered_json;

std::string placeIn(const Json& scene, SceneGenerator& random) {
  const Json anchor = scene.value(Json::json_pointer("/sea/anchor"), Json::object());
  const auto about = [&](const char* key) {
    const Json value = anchor.value(key, Json(0.0));
    return (value.is_number() ? value.get<double>() : 0.0) + 0.01 * (random.uniform() - 0.5);
  };
  return fmt::format("{:.6f},{:.6f}", about("latitude_deg"), about("longitude_deg"));
}

std::vector<std::string> commandOn(const Json& scene, SceneGenerator& random) {
  const std::string time = fmt::format("{:.3f}", random.chance(0.2) ? 0.0 : 3.0 * random.uniform());
  switch (random.below(6)) {
    case 0:
      return {"run", "SCENE", "--out", "OUT"};
    case 1:
      return {"query", "SCENE", "--time", time, "--json", "--at", placeIn(scene, random)};
    case 2:
      return {"query", "SCENE", "--time", time, "--json",      "--orbital",
              "--pressure", "--z", "-2",      "--at", placeIn(scene, random)};
    case 3:
      return {"explain", "SCENE", "--time", time, "--json"};
    case 4: {
      static const char* const techniques[] = {"projected_grid", "radial_grid", "post_process"};
      return {"render",  "SCENE", "--time",      time,         "--size",
              "48x27",   "--out", "OUT/p.png",   "--technique", techniques[random.below(3)]};
    }
    default:
      return {"fit",
              fmt::format("jonswap:{:.3g},{:.3g},{:.3g}", 0.01 + 10.0 * random.uniform(),
                          0.5 + 20.0 * random.uniform(), 1.0 + 9.0 * random.uniform()),
              "--from-deg",
              fmt::format("{:.1f}", 360.0 * random.uniform()),
              "--octaves",
              std::to_string(1 + random.below(8)),
              "--model",
              random.chance(0.5) ? "group" : "perlin",
              "--out",
              "OUT/sea.yaml"};
  }
}

/// Tries scenes with one child of `node` less each; keeps those that still fail.
class Shrinking {
 public:
  Shrinking(HardCase hardCase, const std::function<bool(const HardCase&)>& fails, int most)
      : best_(std::move(hardCase)), fails_(fails), left_(most) {}

  HardCase result() {
    while (left_ > 0 && leaveOut(Json::json_pointer())) {
    }
    return best_;
  }

 private:
  // True if anything could be left out below `at`.
  bool leaveOut(const Json::json_pointer& at) {
    bool any = false;
    const Json node = best_.scene[at];
    for (std::size_t i = node.size(); i-- > 0 && left_ > 0;) {
      auto entry = node.begin();
      std::advance(entry, i);
      const auto child = node.is_array() ? at / i : at / entry.key();
      HardCase without = best_;
      node.is_array() ? without.scene[at].erase(i)
                      : static_cast<void>(without.scene[at].erase(entry.key()));
      --left_;
      if (fails_(without)) {
        best_ = std::move(without);
        any = true;
      } else if (entry->is_structured()) {
        any = leaveOut(child) || any;
      }
    }
    return any;
  }

  HardCase best_;
  const std::function<bool(const HardCase&)>& fails_;
  int left_;
};

}  // namespace

HardCase randomCase(std::uint64_t seed, const std::vector<std::filesystem::path>& examples) {
  SceneGenerator random(seed, examples);
  HardCase hardCase{"random " + std::to_string(seed), "random scenes", "", random.scene(), {}, {}};
  hardCase.arguments = commandOn(hardCase.scene, random);
  const bool takesScene = hardCase.arguments[1] == "SCENE";
  if (!takesScene) hardCase.scene = nullptr;
  if (takesScene && random.chance(1.0 / 3.0)) {
    hardCase.property = "refuses a scene with " + random.breakOne(hardCase.scene);
    hardCase.expectation = {Expected::refuses, "", true};
  } else {
    hardCase.property = "works, or says why not";
  }
  return hardCase;
}

HardCase shrunk(HardCase hardCase, const std::function<bool(const HardCase&)>& fails, int most) {
  if (!hardCase.scene.is_object()) return hardCase;
  return Shrinking(std::move(hardCase), fails, most).result();
}

}  // namespace seaway::bridge
