#pragma once

#include <chrono>
#include <compare>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "surface/disturbance/wake_listener.h"

namespace seaway::bridge {

/// Who has asked lately where wakes may be, and for when. Not thread-safe.
///
/// Wakes are there at one time only: the latest that anyone has asked for in the last five
/// seconds of real time. A host whose clock is behind another's is answered without them, with a
/// status; when the other falls silent, or begins again, the wakes follow.
class WakeAttention {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::seconds patience{5};

  void note(double t, const WakeListener& listener, Clock::time_point now);

  struct Call {
    double time = 0.0;
    std::vector<WakeListener> listeners;
  };
  /// Forgets who has not asked for `patience`; what the others want. No listeners: nobody is there.
  Call call(Clock::time_point now);

 private:
  /// Listeners of one patch of water, one kind and some seconds count as one: the last.
  struct Key {
    std::int64_t x, y, epoch;
    std::uint32_t vessel;
    auto operator<=>(const Key&) const = default;
  };
  struct Heard {
    WakeListener listener;
    double time;
    Clock::time_point when;
  };
  std::map<Key, Heard> heard_;
};

}  // namespace seaway::bridge
