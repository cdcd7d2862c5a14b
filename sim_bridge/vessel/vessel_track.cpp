#include "sim_bridge/vessel/vessel_track.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "surface/constants.h"
#include "surface/state_archive.h"

namespace seaway::bridge {
namespace {

/// Rounding of times that are meant to lie on the grid of intervals, in intervals.
constexpr double onGrid = 1e-6;

double slotOf(double t) { return std::floor(t / VesselTrack::interval + onGrid); }

CoursePoint between(double t0, const CoursePoint& a, double t1, const CoursePoint& b, double t) {
  const double span = t1 - t0, u = (t - t0) / span;
  const double rise = u * u * (3.0 - 2.0 * u);
  const glm::dvec2 bend = span * u * (1.0 - u) * ((1.0 - u) * a.velocity - u * b.velocity);
  return {glm::mix(a.position, b.position, rise) + bend,
          a.direction + u * std::remainder(b.direction - a.direction, 2.0 * pi),
          glm::mix(a.velocity, b.velocity, u)};
}

}  // namespace

void VesselTrack::record(double t, const CoursePoint& place) {
  // The present place gives way to the next unless it is the first of its interval.
  const std::size_t count = entries_.size();
  if (count > 1 && slotOf(entries_[count - 1].time) == slotOf(entries_[count - 2].time)) {
    entries_.pop_back();
  }
  entries_.push_back({t, place});
  while (entries_.front().time < t - horizon) entries_.pop_front();
}

CoursePoint VesselTrack::at(double t) const {
  if (entries_.empty() || t < 0.0) return before_.at(t);
  const Entry& last = entries_.back();
  if (t >= last.time) {
    CoursePoint place = last.place;
    place.position += (t - last.time) * place.velocity;
    return place;
  }
  const auto after = std::upper_bound(entries_.begin(), entries_.end(), t,
                                      [](double time, const Entry& e) { return time < e.time; });
  if (after == entries_.begin()) return entries_.front().place;
  const Entry& before = *(after - 1);
  return between(before.time, before.place, after->time, after->place, t);
}

template <class Archive>
void VesselTrack::archive(Archive& archive) {
  archiveRow(archive, entries_);
}

template void VesselTrack::archive(StateWriter&);
template void VesselTrack::archive(StateReader&);

}  // namespace seaway::bridge
