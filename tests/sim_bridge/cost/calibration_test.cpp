#include "sim_bridge/cost/calibration.h"

#include <gtest/gtest.h>

#include "sim_bridge/cost/study.h"
#include "sim_bridge/scene/scene_loader.h"
#include "sim_bridge/scene/sea.h"

namespace seaway::bridge {
namespace {

Calibration of(const char* scene) {
  const Scene loaded = loadScene(std::string(SEAWAY_SOURCE_DIR "/configs/scenes/") + scene);
  return calibrate(buildSea(loaded), {.quick = true});
}

// Of 16 batches of 1024 points the shares scatter by 0.4 %; few octaves are no exact Gaussian sum.
TEST(Calibration, StatedStandardDeviationsCoverTheErrorsOfScenes) {
  for (const char* scene : {"canaveral.yaml", "storm.yaml"}) {
    const Calibration calibration = of(scene);
    ASSERT_GE(calibration.leftOut.size(), 8u);
    for (const LeftOutCheck& check : calibration.leftOut) {
      EXPECT_NEAR(check.measured / check.predicted, 1.0, 0.03) << scene << check.kept;
      EXPECT_NEAR(check.within[0], 0.68, 0.05) << scene << check.kept;
      EXPECT_GE(check.within[1], 0.95) << scene << check.kept;
      EXPECT_GE(check.within[2], 0.99) << scene << check.kept;
    }
  }
}

TEST(Calibration, BoundsHoldAndAreNoLooserThanTenTimesTheLargestError) {
  for (const char* scene : {"canaveral.yaml", "storm.yaml"}) {
    for (const BoundCheck& check : of(scene).bounds) {
      EXPECT_LE(check.largest, check.bound) << scene << check.reach;
      EXPECT_LE(check.bound, 10.0 * check.largest) << scene << check.reach;
    }
  }
}

TEST(CalibrationHard, FlatWaterHasNothingToCheck) { EXPECT_TRUE(of("calm.yaml").leftOut.empty()); }

}  // namespace
}  // namespace seaway::bridge
