#pragma once

#include <cstddef>
#include <deque>
#include <optional>

#include "surface/disturbance/wake_window.h"

namespace seaway {

/// Where a vessel was at a time, in the water's frame.
struct VesselPose {
  double time = 0.0;  ///< s since the scene's epoch
  HullPlace place;
};

enum class PoseAnswer {
  accepted,
  notFinite,  ///< NaN or infinite, or an immersion below 0: the log is as before
  notLater,   ///< not after the last pose: the log is as before
};

/// A vessel's past, as far as its waves are still about. Bounded: poses older than `horizon` are
/// dropped, of a vessel at rest no more than three are kept, and of those within one interval of
/// the time grid only the last two, for no more can be told from them: the place at a time is
/// reckoned from poses up to that time alone, so that a step once taken is never taken otherwise
/// when later poses arrive.
class PoseLog {
 public:
  /// Times are kept apart by `interval` s; the past by `horizon` s.
  PoseLog(double interval, double horizon) : interval_(interval), horizon_(horizon) {}

  PoseAnswer record(const VesselPose& pose);

  bool empty() const { return entries_.empty(); }
  std::size_t size() const { return entries_.size(); }
  double earliest() const { return entries_.front().pose.time; }
  double latest() const { return entries_.back().pose.time; }

  /// The place at `time`, reckoned on (dead reckoning with constant speed and rate of turn) from
  /// the last poses at or before `known` ≤ time. Nothing before the first pose.
  std::optional<HullPlace> placeAt(double time, double known) const;

  /// The same; the first place before the first pose. The log is not empty.
  HullPlace placeOrFirst(double time, double known) const;

  /// Time of the last jump at or before `known`: a move faster than 100 m/s is no sailing. The
  /// first pose counts as one.
  double lastJump(double known) const;

  /// Whether a jump lies in (from, to]; the first pose counts as one.
  bool jumpedWithin(double from, double to) const;

  /// Whether the vessel moved by more than a centimetre or a hundredth of a radian, or was lifted
  /// or lowered, between two times.
  bool movedBetween(double from, double to) const;

  /// The latest time before `time` at which the vessel was `distance` m or more away from where it
  /// is at `time`; `earliest` of the log or of the last jump where there is none.
  double timeAway(double time, double distance) const;

  std::size_t memoryBytes() const { return entries_.size() * sizeof(Entry); }

  /// Writes or reads the state: see surface/state_archive.h.
  template <class Archive>
  void archive(Archive& archive);

 private:
  struct Entry {
    VesselPose pose;
    bool jumped = false;  // since the entry before
  };
  /// First entry after `time`.
  std::size_t after(double time) const;

  double interval_, horizon_;
  std::deque<Entry> entries_;
};

}  // namespace seaway
