#include "surface/disturbance/pose_log.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "surface/constants.h"
#include "surface/state_archive.h"

namespace seaway {
namespace {

constexpr double fastest = 100.0;            // m/s: no vessel sails faster
constexpr double largestReckonedTurn = 0.5;  // rad: more is no steady turn, but a new heading

/// Rounding of times that are meant to lie on the grid, in intervals.
constexpr double onGrid = 1e-6;

glm::dvec2 turned(glm::dvec2 v, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * v.x - s * v.y, s * v.x + c * v.y};
}

}  // namespace

PoseAnswer PoseLog::record(const VesselPose& pose) {
  const HullPlace& place = pose.place;
  const bool finite = std::isfinite(pose.time) && std::isfinite(place.position.x) &&
                      std::isfinite(place.position.y) && std::isfinite(place.heading) &&
                      std::isfinite(place.immersion) && place.immersion >= 0.0;
  if (!finite) return PoseAnswer::notFinite;
  bool jumped = true;
  if (!entries_.empty()) {
    const VesselPose& last = entries_.back().pose;
    if (!(pose.time > last.time)) return PoseAnswer::notLater;
    jumped = glm::length(place.position - last.place.position) > fastest * (pose.time - last.time);
  }
  // A vessel at rest: the last of its poses only moves on in time.
  if (entries_.size() > 2 && std::all_of(entries_.end() - 3, entries_.end(),
                                         [&](const Entry& e) { return e.pose.place == place; })) {
    entries_.back().pose.time = pose.time;
    return PoseAnswer::accepted;
  }
  // The interval that ends at a grid time: (n − 1, n].
  const auto slot = [&](const Entry& entry) {
    return std::ceil(entry.pose.time / interval_ - onGrid);
  };
  entries_.push_back({pose, jumped});
  const std::size_t n = entries_.size();
  if (n >= 3 && slot(entries_[n - 1]) == slot(entries_[n - 3]) && !entries_[n - 2].jumped &&
      !entries_[n - 1].jumped) {
    entries_[n - 3].pose = entries_[n - 2].pose;
    entries_.erase(entries_.end() - 2);
  }
  while (entries_.size() > 2 && entries_[1].pose.time < pose.time - horizon_) entries_.pop_front();
  return PoseAnswer::accepted;
}

std::size_t PoseLog::after(double time) const {
  const auto found =
      std::upper_bound(entries_.begin(), entries_.end(), time + onGrid * interval_,
                       [](double t, const Entry& entry) { return t < entry.pose.time; });
  return static_cast<std::size_t>(found - entries_.begin());
}

std::optional<HullPlace> PoseLog::placeAt(double time, double known) const {
  const std::size_t next = after(known);
  if (next == 0) return std::nullopt;
  const Entry& last = entries_[next - 1];
  HullPlace place = last.pose.place;
  const double on = time - last.pose.time;
  if (next == 1 || last.jumped || on == 0.0) return place;
  const VesselPose& before = entries_[next - 2].pose;
  const double past = last.pose.time - before.time;
  const glm::dvec2 velocity = (place.position - before.place.position) / past;
  const double rate = std::remainder(place.heading - before.place.heading, 2.0 * pi) / past;
  const double turn = 0.5 * rate * (past + on);  // from the middle of the chord to that of the next
  if (std::abs(turn) > largestReckonedTurn) {
    place.position += velocity * on;
    return place;
  }
  place.position += turned(velocity, turn) * on;
  place.heading += rate * on;
  return place;
}

HullPlace PoseLog::placeOrFirst(double time, double known) const {
  return placeAt(time, known).value_or(entries_.front().pose.place);
}

bool PoseLog::jumpedWithin(double from, double to) const {
  const std::size_t end = after(to);
  for (std::size_t i = after(from); i < end; ++i) {
    if (entries_[i].jumped) return true;
  }
  return false;
}

double PoseLog::lastJump(double known) const {
  std::size_t i = after(known);
  while (i > 1 && !entries_[i - 1].jumped) --i;
  return i == 0 ? earliest() : entries_[i - 1].pose.time;
}

bool PoseLog::movedBetween(double from, double to) const {
  const std::size_t next = after(from), end = after(to);
  const std::size_t first = next == 0 ? 0 : next - 1;
  for (std::size_t i = first + 1; i < end; ++i) {
    const HullPlace &a = entries_[first].pose.place, &b = entries_[i].pose.place;
    if (glm::length(a.position - b.position) > 0.01 || a.immersion != b.immersion ||
        std::abs(std::remainder(a.heading - b.heading, 2.0 * pi)) > 0.01) {
      return true;
    }
  }
  return false;
}

double PoseLog::timeAway(double time, double distance) const {
  const std::size_t end = after(time);
  if (end == 0) return earliest();
  const glm::dvec2 now = entries_[end - 1].pose.place.position;
  for (std::size_t i = end; i-- > 0;) {
    if (glm::length(entries_[i].pose.place.position - now) >= distance) {
      return entries_[i].pose.time;
    }
    if (entries_[i].jumped) return entries_[i].pose.time;
  }
  return earliest();
}

template <class Archive>
void PoseLog::archive(Archive& archive) {
  archiveRow(archive, entries_);
}

template void PoseLog::archive(StateWriter&);
template void PoseLog::archive(StateReader&);

}  // namespace seaway
