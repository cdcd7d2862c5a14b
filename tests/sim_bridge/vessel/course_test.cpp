#include "sim_bridge/vessel/course.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "surface/angles.h"

namespace seaway::bridge {
namespace {

TEST(Course, StraightCourseIsALine) {
  const Course course({10.0, -5.0}, radiansFromDegrees(90.0), 6.0, 0.0);
  const CoursePoint point = course.at(100.0);
  EXPECT_NEAR(point.position.x, 10.0, 1e-12);
  EXPECT_NEAR(point.position.y, 595.0, 1e-12);
  EXPECT_NEAR(point.velocity.y, 6.0, 1e-15);
}

TEST(Course, TurningCourseIsACircleThatCloses) {
  const double turn = radiansFromDegrees(3.0);
  const Course course({0.0, 0.0}, 0.7, 5.0, turn);
  const double radius = 5.0 / turn;
  const glm::dvec2 centre = radius * glm::dvec2(-std::sin(0.7), std::cos(0.7));
  for (double t = 0.0; t < 120.0; t += 7.0) {
    EXPECT_NEAR(glm::distance(course.at(t).position, centre), radius, 1e-10);
  }
  EXPECT_NEAR(glm::length(course.at(120.0).position), 0.0, 1e-10);
}

TEST(Course, VelocityIsTheDerivativeOfThePosition) {
  const Course course({3.0, 4.0}, -1.0, 8.0, -0.05);
  const double h = 1e-4;
  const glm::dvec2 difference =
      (course.at(9.0 + h).position - course.at(9.0 - h).position) / (2.0 * h);
  EXPECT_NEAR(glm::distance(difference, course.at(9.0).velocity), 0.0, 1e-8);
}

TEST(CourseHard, AVanishingTurnIsStillTheArc) {
  // At ω = 1e-12 rad/s the arc departs from the line by ½ U ω t², 4.5e-8 m after 300 s.
  const Course line({0.0, 0.0}, 0.3, 10.0, 0.0);
  for (const double turn : {1e-12, 1e-300, -1e-12}) {
    const Course arc({0.0, 0.0}, 0.3, 10.0, turn);
    EXPECT_NEAR(glm::distance(arc.at(300.0).position, line.at(300.0).position), 0.0, 1e-6);
  }
}

}  // namespace
}  // namespace seaway::bridge
