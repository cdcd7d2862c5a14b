#include "sim_bridge/vessel/course.h"

#include <cmath>

#include "surface/angles.h"

namespace seaway::bridge {

CoursePoint Course::at(double t) const {
  const double halfTurn = 0.5 * turn_ * t;
  // Chord of the arc: its length over that of the arc is sin(h)/h.
  const double chord = halfTurn == 0.0 ? 1.0 : std::sin(halfTurn) / halfTurn;
  const double direction = direction_ + turn_ * t;
  return {start_ + speed_ * t * chord * unitVector(direction_ + halfTurn), direction,
          speed_ * unitVector(direction)};
}

}  // namespace seaway::bridge
