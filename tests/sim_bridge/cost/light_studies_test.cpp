#include <gtest/gtest.h>

#include "sim_bridge/cost/study.h"
#include "sim_bridge/scene/scene_loader.h"
#include "sim_bridge/scene/sea.h"

// What shadows and the water seen from inside cost, and where there is nothing to study.
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
    // Rims of shadows are some pixels of those in shadow.
    if (point.setting == studies[0].chosen) {
      EXPECT_LT(point.error, 10.0);
    }
  }
}

TEST(LightStudies, MoreSamplesComeNearerToManyUnderWater) {
  expectFalling(of(studyUnderWater, "under_water.yaml"), "light_under_water");
}

TEST(LightStudies, ThereAreNoneWhereTheSceneDoesNotCallForThem) {
  EXPECT_TRUE(of(studyShadows, "night.yaml").empty());
  EXPECT_TRUE(of(studyUnderWater, "canaveral.yaml").empty());
}

}  // namespace
}  // namespace seaway::bridge
