#include <gtest/gtest.h>

#include <filesystem>
#include <glm/geometric.hpp>
#include <optional>

#include "sim_bridge/commands/schema_command.h"
#include "sim_bridge/scene/scene_loader.h"
#include "sim_bridge/scene/sea.h"
#include "sim_bridge/vessel/vessel_mesh.h"
#include "tests/sim_bridge/test_support.h"

namespace seaway::bridge {
namespace {

namespace fs = std::filesystem;

const fs::path configs = fs::path(SEAWAY_SOURCE_DIR) / "configs";

std::vector<fs::path> filesIn(const char* folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(configs / folder)) files.push_back(entry.path());
  return files;
}

// Does a ray straight up from `from` meet the triangle?
bool isBelow(glm::dvec3 from, glm::dvec3 a, glm::dvec3 b, glm::dvec3 c) {
  const auto side = [&](glm::dvec3 p, glm::dvec3 q) {
    return (q.x - p.x) * (from.y - p.y) - (q.y - p.y) * (from.x - p.x);
  };
  const double ab = side(a, b);
  const double bc = side(b, c);
  const double ca = side(c, a);
  if (!((ab > 0 && bc > 0 && ca > 0) || (ab < 0 && bc < 0 && ca < 0))) return false;
  const double height = (bc * a.z + ca * b.z + ab * c.z) / (ab + bc + ca);
  return height > from.z;
}

TEST(Configs, SchemaPageIsWhatTheCommandPrints) {
  EXPECT_EQ(test::readFile(configs / "SCHEMA.md"), schemaPage())
      << "write it again: seaway schema > configs/SCHEMA.md";
}

TEST(Configs, EverySceneLoadsAndItsSeaCanBeBuilt) {
  for (const fs::path& file : filesIn("scenes")) {
    SCOPED_TRACE(file);
    const Scene scene = loadScene(file);
    EXPECT_FALSE(scene.cameras.empty());
    const Sea sea = buildSea(scene);
    EXPECT_NEAR(sea.surface.waves().significantWaveHeight(), sea.hm0Asked, 1e-9);
  }
}

TEST(Configs, EveryVesselAndSeaStateLoads) {
  for (const fs::path& file : filesIn("vessels")) EXPECT_NO_THROW(loadVesselModel(file)) << file;
  for (const fs::path& file : filesIn("sea_states")) EXPECT_NO_THROW(loadSeaState(file)) << file;
}

TEST(Configs, TheDemonstrationIsTheMeasuredRecord) {
  const Scene scene = loadScene(configs / "scenes/canaveral.yaml");
  const auto& state = std::get<ParametricState>(scene.sea.state);
  EXPECT_EQ(scene.sea.anchor.latitude_deg, 28.878);
  EXPECT_EQ(scene.sea.anchor.longitude_deg, -78.467);
  EXPECT_EQ(state.significantWaveHeight, 1.12);
  EXPECT_EQ(state.peakPeriod, 5.6);
  EXPECT_EQ(state.from_deg, 196.0);
  EXPECT_EQ(scene.vessels.at(0).speed, 6.0);
}

TEST(Configs, NoMountedCameraIsInsideItsVesselsDrawing) {
  for (const fs::path& file : filesIn("scenes")) {
    const Scene scene = loadScene(file);
    for (const SceneCamera& camera : scene.cameras) {
      for (const SceneVessel& vessel : scene.vessels) {
        if (vessel.name != camera.mount) continue;
        for (const auto& part : vesselMesh(vessel.model).parts) {
          for (std::size_t i = 0; i < part.vertices.size(); i += 3) {
            EXPECT_FALSE(isBelow(camera.position, part.vertices[i], part.vertices[i + 1],
                                 part.vertices[i + 2]))
                << file << ": camera " << camera.name << " has something above it";
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace seaway::bridge
