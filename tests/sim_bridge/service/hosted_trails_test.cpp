#include "sim_bridge/service/hosted_trails.h"

#include <gtest/gtest.h>

#include <cmath>
#include <thread>

#include "sim_bridge/service/frame_maker.h"
#include "tests/sim_bridge/service/served_waters.h"

// Foam and smoothed water behind hulls that hosts sail.
namespace seaway::bridge {
namespace {

using test::pilotScene;
using test::ServedWaters;

const std::string noWakes = "effects: {wake: off}\n";

double foamAt(const ServedWaters& served, glm::dvec2 place, double t) {
  const auto detail = served.sea.surface()->extras().detail;
  return detail && detail->cover.foam ? detail->cover.foam->coverAt(place, t) : 0.0;
}

/// The most foam on a line across a track northwards along `x`.
double foamAcross(const ServedWaters& served, double x, double y, double t) {
  double most = 0.0;
  for (double aside = -4.0; aside <= 4.0; aside += 0.1) {
    most = std::max(most, foamAt(served, {x + aside, y}, t));
  }
  return most;
}

/// North along `x` at 5 m/s, told every `interval` s.
void sail(ServedWaters& served, std::uint32_t hull, double x, double from, double to,
          double interval = 0.1) {
  const int first = static_cast<int>(std::lround(from / interval));
  for (int i = first; i <= static_cast<int>(std::lround(to / interval)); ++i) {
    EXPECT_TRUE(
        served.sea.place(hull, i * interval, served.poseAt({x, 5.0 * (i * interval - from)})));
  }
}

// The scene has the pilot on the very same course: in closed form it leaves the same trail.
TEST(HostedTrails, AHullLeavesTheTrailOfASceneVesselOnTheSameCourse) {
  ServedWaters course(pilotScene(noWakes)), hosted(pilotScene(noWakes, "0"));
  sail(hosted, hosted.sea.addHull(0), 0.0, 0.0, 12.1);
  course.bringWakes(12.0, {0.0, 0.0});
  hosted.bringWakes(12.0, {0.0, 0.0});
  double largest = 0.0;
  // Where both have been in their time: the scene's has a past before the epoch as well, which the
  // widened strokes behind the hull show until they are 22 s old.
  for (double y = 30.0; y <= 55.0; y += 0.7) {
    for (double x = -2.5; x <= 2.5; x += 0.3) {
      const double expected = foamAt(course, {x, y}, 12.0), given = foamAt(hosted, {x, y}, 12.0);
      largest = std::max(largest, expected);
      // Places between poses, velocities by differences of places: a cell of 0.25 m at the edge of
      // a stroke may be on the other side.
      if (y > 40.0) {
        EXPECT_NEAR(given, expected, 0.15) << x << " " << y;
      }
    }
  }
  EXPECT_GT(largest, 0.3);
}

TEST(HostedTrails, LieWhereTheHullHasBeenAndNotWhereItHasNot) {
  ServedWaters served(pilotScene(noWakes, "0"));
  sail(served, served.sea.addHull(0), 20.0, 0.0, 12.0);
  served.bringWakes(12.0, {20.0, 0.0});
  EXPECT_GT(foamAcross(served, 20.0, 40.0, 12.0), 0.2);
  EXPECT_EQ(foamAcross(served, 20.0, 90.0, 12.0), 0.0);
  EXPECT_EQ(foamAcross(served, -20.0, 40.0, 12.0), 0.0);
}

TEST(HostedTrails, PosesThatComeLateAndOftenLeaveTheSameTrail) {
  ServedWaters early(pilotScene(noWakes, "0")), late(pilotScene(noWakes, "0"));
  const std::uint32_t hull = late.sea.addHull(0);
  sail(early, early.sea.addHull(0), 20.0, 0.0, 12.0, 0.05);
  late.bringWakes(12.0, {20.0, 0.0});
  sail(late, hull, 20.0, 0.0, 12.0, 0.005);
  early.bringWakes(12.0, {20.0, 0.0});
  late.bringWakes(12.3, {20.0, 0.0});
  early.bringWakes(12.3, {20.0, 0.0});
  for (double y = 10.0; y < 58.0; y += 1.0) {
    EXPECT_NEAR(foamAcross(late, 20.0, y, 12.3), foamAcross(early, 20.0, y, 12.3), 0.02) << y;
  }
  EXPECT_GT(foamAcross(late, 20.0, 40.0, 12.3), 0.2);
}

TEST(HostedTrails, TwoHullsOfOneVesselLeaveOneEachAndStayWhenTheHostHasGone) {
  ServedWaters served(pilotScene(noWakes, "0"));
  const std::uint32_t one = served.sea.addHull(0), two = served.sea.addHull(0);
  sail(served, one, 20.0, 0.0, 12.0);
  sail(served, two, -30.0, 0.0, 12.0);
  served.sea.removeHull(one);
  served.bringWakes(12.0, {20.0, 0.0});
  EXPECT_GT(foamAcross(served, 20.0, 40.0, 12.0), 0.2);
  EXPECT_GT(foamAcross(served, -30.0, 40.0, 12.0), 0.2);
}

TEST(HostedTrails, AreSeenInPicturesAndWhereTheSceneSwitchesThemOffAreNot) {
  const auto picture = [](const std::string& effects, bool sails) {
    ServedWaters served(pilotScene(effects, "0"));
    FrameMaker frames(served.sea);
    const std::uint32_t hull = served.sea.addHull(0);
    sail(served, hull, 0.0, 0.0, 16.0);
    if (!sails) served.sea.removeHull(hull);
    served.bringWakes(16.0, {0.0, 0.0});
    served.sea.removeHull(hull);  // its trail alone
    return frames.draw({.camera = "mast", .t = 16.0, .size = {96, 64}})->colour.rgb;
  };
  const auto bare = picture("effects: {wake: off, trail: off}\n", true);
  EXPECT_NE(picture(noWakes, true), bare);
  EXPECT_EQ(picture("effects: {wake: off, trail: off}\n", false), bare);
}

TEST(HostedTrailsHard, LeapsLeaveNoneAndOldPosesBeforeTheEpochNeither) {
  ServedWaters served(pilotScene(noWakes, "0"));
  const std::uint32_t hull = served.sea.addHull(0);
  served.sea.place(hull, -2.0, served.poseAt({0.0, 0.0}));
  served.sea.place(hull, 1.0, served.poseAt({0.0, 1000.0}));
  served.sea.place(hull, 2.0, served.poseAt({0.0, 2000.0}));
  served.bringWakes(3.0, {0.0, 0.0});
  EXPECT_EQ(served.sea.surface()->extras().detail, nullptr);
}

TEST(HostedTrailsHard, PosesBeforeTheEpochAreCountedAndTheTrailBeginsThere) {
  ServedWaters served(pilotScene(noWakes, "0"));
  const std::uint32_t hull = served.sea.addHull(0);
  sail(served, hull, 20.0, -6.0, 6.0);
  EXPECT_FALSE(served.sea.place(hull, -1e300, served.poseAt({0.0, 0.0})));
  served.bringWakes(6.0, {20.0, 30.0});
  const auto events = served.sea.meters().readEvents();
  ASSERT_EQ(events.size(), 1u);
  EXPECT_EQ(events[0].endpoint + "." + events[0].name, "sea.poses_before_epoch");
  EXPECT_EQ(events[0].count, 60u) << "the one that was refused is none";
  // It passed y = 30 m at the epoch; strokes reach half its length of 12 m farther back.
  EXPECT_EQ(foamAcross(served, 20.0, 15.0, 6.0), 0.0);
  EXPECT_GT(foamAcross(served, 20.0, 45.0, 6.0), 0.2);
  const std::uint32_t other = served.sea.addHull(0);
  for (int i = -50; i < 50; ++i) served.sea.place(other, 0.01 * i, served.poseAt({-50.0, 0.0}));
  served.sea.replaceScene(served.scene, buildSea(served.scene));
  EXPECT_EQ(served.sea.meters().readEvents()[0].count, 110u) << "each, and once";
}

TEST(HostedTrailsHard, AHostThatBeginsAgainLeavesItsTrailAgain) {
  ServedWaters served(pilotScene(noWakes, "0"));
  const std::uint32_t hull = served.sea.addHull(0);
  sail(served, hull, 20.0, 0.0, 12.0);
  served.bringWakes(12.0, {20.0, 0.0});
  std::this_thread::sleep_for(WakeAttention::patience + std::chrono::milliseconds(300));
  sail(served, hull, -30.0, 0.0, 10.0);
  served.bringWakes(10.0, {-30.0, 0.0});
  EXPECT_GT(foamAcross(served, -30.0, 30.0, 10.0), 0.2);
  EXPECT_EQ(foamAcross(served, 20.0, 30.0, 10.0), 0.0) << "what was before never happened";
}

}  // namespace
}  // namespace seaway::bridge
