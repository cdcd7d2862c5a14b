#pragma once

#include <glm/vec2.hpp>

namespace seaway::bridge {

/// A vessel's place and heading in the sea plane.
struct CoursePoint {
  glm::dvec2 position{0.0};  ///< m
  double direction = 0.0;    ///< of the bow, rad counter-clockwise from east
  glm::dvec2 velocity{0.0};  ///< over ground, m/s
};

/// Prescribed motion: constant speed along a straight line or, with a rate of turn, a circle of the
/// sea plane. In closed form, so that no error grows with time. Lengths are those of the plane,
/// which exceed true ones by at most Geodesy's scale error (1.7e-4 within 200 km of the anchor).
class Course {
 public:
  /// `start` m, `direction` rad, `speed` m/s, `turn` rad/s counter-clockwise.
  Course(glm::dvec2 start, double direction, double speed, double turn)
      : start_(start), direction_(direction), speed_(speed), turn_(turn) {}

  CoursePoint at(double t) const;  ///< t in s since the scene's epoch

  double speed() const { return speed_; }  ///< m/s, negative astern

 private:
  glm::dvec2 start_;
  double direction_;
  double speed_;
  double turn_;
};

}  // namespace seaway::bridge
