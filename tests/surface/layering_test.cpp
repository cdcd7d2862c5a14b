#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

/// The dependency direction of the layers, and the one owner of each third party.
namespace {

namespace fs = std::filesystem;

struct Rule {
  std::string forbidden;            ///< start of an include's path
  std::vector<std::string> owners;  ///< path prefixes that may include it; all others may not
};

const std::vector<Rule> rules = {
    {"sim_bridge/", {"sim_bridge/"}},
    {"render/", {"sim_bridge/", "render/"}},
    {"ceres/", {"surface/fit/"}},
    {"GeographicLib/", {"surface/geodesy."}},
    {"openvdb/", {"surface/disturbance/layers/", "surface/hull/hull_repair.cpp"}},
    {"assimp/", {"surface/hull/hull_file.cpp", "surface/hull/coloured_mesh.cpp"}},
    {"mujoco/", {"sim_bridge/mujoco/"}},
    {"fftw", {"surface/fft/", "sim_bridge/cost/rivals/"}},
    {"glad/", {"render/"}},
    {"GL/", {"render/"}},
    {"png.h", {"render/png.cpp", "sim_bridge/scene/png_heights.cpp"}},
    {"OpenEXR/", {"render/exr.cpp"}},
    {"yaml-cpp/", {"sim_bridge/"}},
    {"CLI/", {"sim_bridge/"}},
    {"nlohmann/", {"sim_bridge/", "surface/spectra/readers/spotter.cpp"}},
    {"grpc", {"sim_bridge/service/", "sim_bridge/grpc/"}},
    {"asio", {"sim_bridge/cigi/udp_endpoint.cpp", "sim_bridge/grpc/"}},
};

std::vector<std::string> violations() {
  std::vector<std::string> found;
  const fs::path root = SEAWAY_SOURCE_DIR;
  for (const char* layer : {"surface", "render", "sim_bridge"}) {
    for (const auto& entry : fs::recursive_directory_iterator(root / layer)) {
      const std::string extension = entry.path().extension();
      if (extension != ".h" && extension != ".cpp") continue;
      const std::string file = fs::relative(entry.path(), root);
      std::ifstream stream(entry.path());
      for (std::string line; std::getline(stream, line);) {
        if (!line.starts_with("#include ")) continue;
        const std::string header = line.substr(10);
        for (const Rule& rule : rules) {
          if (!header.starts_with(rule.forbidden)) continue;
          bool allowed = false;
          for (const std::string& owner : rule.owners) allowed |= file.starts_with(owner);
          if (!allowed) found.push_back(file + " includes " + header);
        }
      }
    }
  }
  return found;
}

TEST(Layering, NothingIncludesUpwardsAndThirdPartiesHaveOneOwner) {
  for (const std::string& violation : violations()) ADD_FAILURE() << violation;
}

TEST(Layering, TheTopLevelHoldsExactlyTheAgreedEntries) {
  const std::vector<std::string> agreed = {
      "CMakeLists.txt", "CMakePresets.json", "README.md", "LICENSE", "run",   "test", "surface",
      "render",         "sim_bridge",        "tests",     "configs", "build", "out"};
  for (const auto& entry : fs::directory_iterator(SEAWAY_SOURCE_DIR)) {
    const std::string name = entry.path().filename();
    const bool known =
        name.starts_with('.') || std::find(agreed.begin(), agreed.end(), name) != agreed.end();
    EXPECT_TRUE(known) << name;
  }
}

}  // namespace
