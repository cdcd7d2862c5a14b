#include <gtest/gtest.h>

#include "sim_bridge/cost/study.h"
#include "sim_bridge/scene/scene_loader.h"
#include "sim_bridge/scene/sea.h"

// What shadows, the water seen from inside and ground cost, and where there is nothing to study.
namespace seaway::bridge {
namespace {

using Studies = std::vector<Study> (*)(const Scene&, const Sea&, const StudyOptions&);

std::vector<Study> of(Studies studies, const char* scene) {
  const Scene loaded = loadScene(std::string(SEAWAY_SOURCE_DIR "/configs/scenes/") + scene);
  return studies(loaded, buildSea(loaded), {.quick = true});
}

void expectFalling(const std::vector<Study>& studies, const char* name) {
  ASSERT_EQ(studies.size(), 1u);
  const Study& study = studies[0];
  EXPECT_EQ(study.name, name);
  EXPECT_LT(study.points.back().error, 0.5 * study.points.front().error);
  bool hasChosen = false;
  for (const CostPoint& point : study.points) {
    EXPECT_GT(point.cost, 0.0) << point.setting;
    hasChosen = hasChosen || point.setting == study.chosen;
  }
  EXPECT_TRUE(hasChosen);
}

TEST(LightStudies, FinerShadowMapsAgreeBetterWithRaysToTheSun) {
  const std::vector<Study> studies = of(studyShadows, "harbour.yaml");
  expectFalling(studies, "light_shadows");
  for (const CostPoint& point : studies[0].points) {
    // Of thin shadows in a small picture every fifth pixel is at a rim.
    if (point.setting == studies[0].chosen) {
      EXPECT_LT(point.error, 30.0);
    }
  }
}

TEST(LightStudies, MoreSamplesComeNearerToManyUnderWater) {
  expectFalling(of(studyUnderWater, "under_water.yaml"), "light_under_water");
}

TEST(LightStudies, FinerGroundLiesNearerToItsMap) {
  const std::vector<Study> studies = of(studyTerrain, "island.yaml");
  ASSERT_EQ(studies.size(), 1u);
  EXPECT_EQ(studies[0].name, "image_terrain");
  double previous = 0.0;
  for (const CostPoint& point : studies[0].points) {
    EXPECT_GT(point.cost, 0.0) << point.setting;
    // Coarser from one to the next; what neighbouring levels share may differ by chance.
    EXPECT_GE(point.error, 0.9 * previous) << point.setting;
    previous = point.error;
  }
  EXPECT_LT(studies[0].points.front().error, 0.5 * previous);
}

TEST(LightStudies, ThereAreNoneWhereTheSceneDoesNotCallForThem) {
  EXPECT_TRUE(of(studyShadows, "night.yaml").empty());
  EXPECT_TRUE(of(studyUnderWater, "canaveral.yaml").empty());
  EXPECT_TRUE(of(studyTerrain, "canaveral.yaml").empty());
}

}  // namespace
}  // namespace seaway::bridge
