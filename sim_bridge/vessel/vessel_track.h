#pragma once

#include <cstddef>
#include <deque>

#include "sim_bridge/vessel/course.h"

namespace seaway::bridge {

/// Where a free vessel has been: a course before the scene's epoch, what was noted since.
///
/// One place is kept for each 0.1 s of the last 900 s, and the present one; between them positions
/// are interpolated with the velocities at both ends (cubic Hermite), headings linearly.
class VesselTrack {
 public:
  static constexpr double interval = 0.1;   ///< s
  static constexpr double horizon = 900.0;  ///< s

  explicit VesselTrack(const Course& before) : before_(before) {}

  /// Notes the present place; `t` ≥ 0, later than before.
  void record(double t, const CoursePoint& place);

  /// The place at `t`: on the course before the epoch, the oldest kept where `t` is before all that
  /// are kept, straight on from the present one after it.
  CoursePoint at(double t) const;

  std::size_t memoryBytes() const { return entries_.size() * sizeof(Entry); }

  /// Writes or reads the state: see surface/state_archive.h.
  template <class Archive>
  void archive(Archive& archive);

 private:
  struct Entry {
    double time = 0.0;
    CoursePoint place;
  };
  Course before_;
  std::deque<Entry> entries_;  // rising; the last is the present
};

}  // namespace seaway::bridge
