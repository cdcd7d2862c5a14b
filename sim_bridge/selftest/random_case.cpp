#include "sim_bridge/selftest/random_case.h"

#include <spdlog/fmt/fmt.h>

#include <cmath>

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

using Words = std::vector<std::string>;

Words fitOf(SceneGenerator& random) {
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

/// A box or Wigley hull from a tender to a tanker, loaded as may be.
Words hullOf(SceneGenerator& random) {
  const double length = 2.0 * std::pow(200.0, random.uniform());
  const double beam = length * (0.05 + 0.4 * random.uniform());
  const double draft = beam * (0.1 + 0.6 * random.uniform());
  const double freeboard = draft * (0.05 + random.uniform());
  Words words{
      "hull",
      random.chance(0.5)
          ? fmt::format("box:{:.4g},{:.4g},{:.4g}", length, beam, draft + freeboard)
          : fmt::format("wigley:{:.4g},{:.4g},{:.4g},{:.4g}", length, beam, draft, freeboard),
      "--triangles", std::to_string(20 + random.below(600)), "--json"};
  if (random.chance(0.5)) {
    words.insert(words.end(), {"--mass", fmt::format("{:.4g}", 1025.0 * length * beam * draft *
                                                                   2.0 * random.uniform())});
  }
  if (random.chance(0.3)) {
    words.insert(words.end(), {"--heel", fmt::format("{:.3g}", 360.0 * random.uniform() - 180.0)});
  }
  if (random.chance(0.3)) {
    words.insert(words.end(), {"--cg", "0", "0", fmt::format("{:.3g}", beam * random.uniform())});
  }
  return words;
}

Words serviceOf(SceneGenerator& random, int& endpoints) {
  Words words{"serve", "SCENE", "--metrics", "0"};
  endpoints = 1;
  for (const char* door : {"--cigi", "--grpc", "--xdyn"}) {
    if (!random.chance(0.4)) continue;
    words.insert(words.end(), {door, "0"});
    ++endpoints;
  }
  if (random.chance(0.5)) words.insert(words.end(), {"--clock", "real"});
  return words;
}

Words tuningOf(SceneGenerator& random) {
  return {"tune",           "SCENE",      "--out",
          "OUT/tuned.yaml", "--height-m", fmt::format("{:.3g}", 0.001 + 0.2 * random.uniform())};
}

Words pictureOf(const std::string& time, SceneGenerator& random) {
  static const char* const techniques[] = {"projected_grid", "radial_grid", "post_process"};
  return {"render", "SCENE", "--time",    time,          "--size",
          "48x27",  "--out", "OUT/p.png", "--technique", techniques[random.below(3)]};
}

/// A command, most often one that most people give.
Words commandOn(const Json& scene, SceneGenerator& random, int& endpoints) {
  const std::string time = fmt::format("{:.3f}", random.chance(0.2) ? 0.0 : 3.0 * random.uniform());
  switch (random.below(12)) {
    case 0:
    case 1:
      return {"run", "SCENE", "--out", "OUT"};
    case 2:
      return {"query", "SCENE", "--time", time, "--json", "--at", placeIn(scene, random)};
    case 3:
      return {"query",
              "SCENE",
              "--time",
              time,
              "--json",
              "--orbital",
              "--pressure",
              "--z",
              "-2",
              "--at",
              placeIn(scene, random)};
    case 4:
      return {"explain", "SCENE", "--time", time, "--json"};
    case 5:
    case 6:
      return pictureOf(time, random);
    case 7:
      return fitOf(random);
    case 8:
      return serviceOf(random, endpoints);
    case 9:
      return hullOf(random);
    case 10:
      return {"sail", "SCENE", "--duration", "2", "--out", "OUT", "--json"};
    default:
      return tuningOf(random);
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
  HardCase hardCase{.name = "random " + std::to_string(seed),
                    .area = "random scenes",
                    .property = "",
                    .scene = random.scene(),
                    .arguments = {},
                    .expectation = {}};
  hardCase.arguments = commandOn(hardCase.scene, random, hardCase.endpoints);
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
