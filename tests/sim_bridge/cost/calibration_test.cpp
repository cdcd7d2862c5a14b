#include "sim_bridge/cost/calibration.h"

#include <gtest/gtest.h>

#include "sim_bridge/cost/study.h"
#include "sim_bridge/scene/scene_loader.h"
#include "sim_bridge/scene/sea.h"

namespace seaway::bridge {
namespace {

Scene sceneOf(const char* file) {
  return loadScene(std::string(SEAWAY_SOURCE_DIR "/configs/scenes/") + file);
}

Calibration of(const char* scene) {
  Scene loaded = sceneOf(scene);
  loaded.cameras.clear();  // the field alone
  loaded.vessels.clear();
  return calibrate(loaded, buildSea(loaded), {.quick = true});
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

std::vector<GridCheck> gridsOf(const char* file) {
  const Scene scene = sceneOf(file);
  return checkGrids(scene, buildSea(scene), {.quick = true});
}

// Some 2000 pixels at each of 6 times see the same few waves: shares scatter by some 2 %.
TEST(Calibration, GridsAreAsFarOffAsTheirSpacingForetells) {
  for (const char* scene : {"canaveral.yaml", "voyage.yaml", "dawn.yaml"}) {
    const auto grids = gridsOf(scene);
    ASSERT_EQ(grids.size(), 4u);
    for (const GridCheck& check : grids) {
      EXPECT_NEAR(check.measured / check.predicted, 1.0, 0.1) << scene << check.side;
      EXPECT_NEAR(check.within[0], 0.68, 0.05) << scene << check.side;
      EXPECT_GE(check.within[1], 0.94) << scene << check.side;
      EXPECT_GE(check.within[2], 0.99) << scene << check.side;
    }
  }
}

// In waves of 9 m each picture shows but a few.
TEST(CalibrationHard, GridsInAStormAreNoFartherOffThanForetold) {
  const auto grids = gridsOf("storm.yaml");
  ASSERT_EQ(grids.size(), 4u);
  for (const GridCheck& check : grids) {
    EXPECT_LE(check.within[0], 0.85) << check.side;
    EXPECT_GE(check.within[0], 0.63) << check.side;
    EXPECT_GE(check.within[1], 0.94) << check.side;
    EXPECT_GE(check.within[2], 0.99) << check.side;
  }
}

// What is left out beyond cells of twice the size is less than what these leave out besides, but
// not by much where short waves are as high as long ones: a factor of two either way.
TEST(Calibration, HalvedCellsForetellTheErrorOfWakes) {
  for (const char* scene : {"canaveral.yaml", "voyage.yaml"}) {
    const auto cells = checkWakeCells(sceneOf(scene));
    ASSERT_EQ(cells.size(), 2u) << scene;
    for (const CellCheck& check : cells) {
      EXPECT_GT(check.measured, 0.5 * check.predicted) << scene << check.cell;
      EXPECT_LT(check.measured, 2.0 * check.predicted) << scene << check.cell;
    }
  }
}

// At 2 m/s a wake's longest waves are 2.6 m long.
TEST(CalibrationHard, CellsThatCarryNoWakeForetellNothing) {
  EXPECT_TRUE(checkWakeCells(sceneOf("storm.yaml")).empty());
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
