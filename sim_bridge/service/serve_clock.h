#pragma once

#include <chrono>
#include <string>

namespace seaway::bridge {

/// The time of a service, s since the scene's epoch: a host's own, or one that runs from 0 on when
/// the clock is made, so many times as fast as real time.
class ServeClock {
 public:
  /// `host`, `real`, or `xN` with N > 0. Throws InputError, which begins with `option`.
  static ServeClock parse(const std::string& option, const std::string& text);

  bool isHosts() const { return speed_ == 0.0; }
  /// 0 where time is the hosts'. Thread-safe.
  double now() const {
    const std::chrono::duration<double> past = std::chrono::steady_clock::now() - start_;
    return speed_ * past.count();
  }

 private:
  explicit ServeClock(double speed) : speed_(speed) {}
  double speed_;  // 0: a host's
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace seaway::bridge
