#include "sim_bridge/cost/advice.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sim_bridge/report/plot.h"
#include "sim_bridge/scene/scene_loader.h"
#include "sim_bridge/scene/sea.h"

namespace seaway::bridge {
namespace {

Study heights() {
  return {"query_octaves",
          "",
          "m",
          "ns/point",
          {{"octaves 0", 0.5, 20.0},
           {"octaves 8", 0.06, 50.0},
           {"octaves 12", 0.04, 80.0},
           {"octaves 24", 0.0, 130.0}}};
}

TEST(CostAdvice, NamesTheFewestOctavesWithinATenthOfTheSeaBesideTheWhole) {
  const auto advice = costAdvice({heights()});
  ASSERT_EQ(advice.size(), 1u);
  EXPECT_EQ(advice[0],
            "Heights within 0.04 m rms, a tenth of the sea's own deviation, cost 80 ns a point "
            "(octaves 12); all of the sea costs 130 ns (octaves 24).");
}

TEST(ParetoFront, IsWhatNothingBeatsInBoth) {
  const auto front = paretoFront({{"d", 0.1, 9.0},
                                  {"worse than b", 0.5, 4.0},
                                  {"a", 2.0, 1.0},
                                  {"none", std::nan(""), 0.5},
                                  {"b", 0.4, 3.0},
                                  {"as good as b", 0.4, 3.0}});
  ASSERT_EQ(front.size(), 3u);
  EXPECT_EQ(front[0].setting, "a");
  EXPECT_EQ(front[1].setting, "b");
  EXPECT_EQ(front[2].setting, "d");
  EXPECT_TRUE(paretoFront({}).empty());
}

TEST(CostStudiesHard, DryPlacesAreNotAskedForTheirHeight) {
  const Scene island = loadScene(SEAWAY_SOURCE_DIR "/configs/scenes/island.yaml");
  const Study study = studyQueryOctaves(island, buildSea(island), {.quick = true});
  EXPECT_GT(study.points.front().error, 0.0);
  EXPECT_EQ(study.points.back().error, 0.0);
}

TEST(PlotHard, WithoutAPointToShowIsDrawnAllTheSame) {
  Plot plot{"nothing", {"x", true}, {"y", false, 0.0}, {}};
  plot.curves = {{"none", {1.0, std::nan("")}, {std::nan(""), 2.0}}};
  EXPECT_NE(svgOf(plot).find("none"), std::string::npos);
}

TEST(CostAdvice, SaysNothingWhereOnlyTheWholeIsAccurate) {
  Study study = heights();
  study.points = {{"octaves 0", 0.5, 20.0}, {"octaves 1", 0.0, 30.0}};
  EXPECT_TRUE(costAdvice({study}).empty());
}

TEST(CostAdvice, SetsAHullInWavesBesideOneInStillPressure) {
  const Study columns{
      "hull_columns", "", "% of weight", "us/evaluation", {{"columns 10x4", 3.0, 13.0}}};
  const Study mesh{"hull_mesh_dynamic",
                   "",
                   "% of weight",
                   "us/evaluation",
                   {{"triangles 200", 0.2, 31.0}, {"triangles 800", 0.06, 98.0}}};
  const auto advice = costAdvice({columns, mesh});
  ASSERT_EQ(advice.size(), 1u);
  EXPECT_NE(advice[0].find("0.2 % of its weight for 31 us (triangles 200"), std::string::npos)
      << advice[0];
  EXPECT_NE(advice[0].find("columns 10x4 it is 3 % off, for 13 us"), std::string::npos)
      << advice[0];
}

TEST(CostAdvice, HasNothingToSayOfStudiesThatAreNotThere) { EXPECT_TRUE(costAdvice({}).empty()); }

}  // namespace
}  // namespace seaway::bridge
