#include "surface/disturbance/pose_log.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace seaway {
namespace {

VesselPose at(double time, double x, double y = 0.0, double heading = 0.0) {
  return {time, {{x, y}, heading, 1.0}};
}

TEST(PoseLog, ReckonsOnFromWhatWasKnown) {
  PoseLog log(0.1, 100.0);
  log.record(at(0.0, 0.0));
  log.record(at(1.0, 5.0));
  log.record(at(2.0, 5.0));
  EXPECT_DOUBLE_EQ(log.placeAt(1.5, 1.0)->position.x, 7.5);  // as if the stop were not known
  EXPECT_DOUBLE_EQ(log.placeAt(2.5, 2.0)->position.x, 5.0);
  EXPECT_FALSE(log.placeAt(0.0, -1.0));
  EXPECT_DOUBLE_EQ(log.placeOrFirst(0.0, -1.0).position.x, 0.0);
}

TEST(PoseLog, ReckonsOnAroundACircle) {
  const double radius = 40.0, rate = 0.2;
  PoseLog log(0.1, 100.0);
  const auto circle = [&](double t) {
    return at(t, radius * std::sin(rate * t), -radius * std::cos(rate * t), rate * t);
  };
  log.record(circle(0.0));
  log.record(circle(0.1));
  const HullPlace reckoned = *log.placeAt(0.2, 0.1), exact = circle(0.2).place;
  EXPECT_NEAR(glm::length(reckoned.position - exact.position), 0.0, 1e-9);
  EXPECT_NEAR(reckoned.heading, exact.heading, 1e-12);
}

TEST(PoseLog, KeepsWhatTheTimeGridNeedsAndNoMore) {
  PoseLog all(1e-4, 10.0), grid(0.1, 10.0);
  for (int i = 0; i <= 100000; ++i) {
    const double t = i * 1e-3;
    const VesselPose pose = at(t, 8.0 * t, std::sin(t), 0.1 * std::sin(t));
    if (i > 90000) {
      ASSERT_EQ(all.record(pose), PoseAnswer::accepted);
    }
    ASSERT_EQ(grid.record(pose), PoseAnswer::accepted);
  }
  EXPECT_LE(grid.size(), 205u);  // two a tenth of a second over ten seconds
  EXPECT_GE(grid.latest() - grid.earliest(), 10.0);
  for (double t = 91.0; t < 99.5; t += 0.1) {
    const double known = std::round(t * 10.0) / 10.0;
    EXPECT_EQ(all.placeAt(known + 0.1, known)->position,
              grid.placeAt(known + 0.1, known)->position);
  }
}

TEST(PoseLogHard, RefusesWhatIsNoPose) {
  PoseLog log(0.1, 100.0);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  log.record(at(0.0, 1.0));
  EXPECT_EQ(log.record(at(1.0, nan)), PoseAnswer::notFinite);
  EXPECT_EQ(log.record(at(nan, 1.0)), PoseAnswer::notFinite);
  EXPECT_EQ(log.record(at(1.0, 0.0, 0.0, std::numeric_limits<double>::infinity())),
            PoseAnswer::notFinite);
  VesselPose lifted = at(1.0, 0.0);
  lifted.place.immersion = -1.0;
  EXPECT_EQ(log.record(lifted), PoseAnswer::notFinite);
  EXPECT_EQ(log.record(at(0.0, 2.0)), PoseAnswer::notLater);
  EXPECT_EQ(log.size(), 1u);
  EXPECT_DOUBLE_EQ(log.placeAt(5.0, 5.0)->position.x, 1.0);
}

TEST(PoseLogHard, AJumpIsNoSpeed) {
  PoseLog log(0.1, 100.0);
  log.record(at(0.0, 0.0));
  log.record(at(0.1, 0.8));
  log.record(at(0.2, 10000.0));
  EXPECT_TRUE(log.jumpedWithin(0.1, 0.2));
  EXPECT_FALSE(log.jumpedWithin(0.0, 0.1));
  EXPECT_DOUBLE_EQ(log.lastJump(0.3), 0.2);
  EXPECT_DOUBLE_EQ(log.placeAt(1.0, 0.5)->position.x, 10000.0);
  log.record(at(0.3, 10000.8));
  EXPECT_NEAR(log.placeAt(0.4, 0.3)->position.x, 10001.6, 1e-9);
}

TEST(PoseLogHard, AWholeDayStaysBounded) {
  PoseLog log(0.1, 300.0);
  for (int i = 0; i < 24 * 3600; ++i) log.record(at(i, 5.0 * i));
  EXPECT_LE(log.size(), 303u);
}

}  // namespace
}  // namespace seaway
