#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "render/render_technique.h"

namespace seaway::render {

/// Notes the wall time of one pass after the other.
class PassTimer {
 public:
  PassTimer(const View& view, FrameStats& stats)
      : view_(view), stats_(stats), start_(Clock::now()) {}

  /// Ends a pass that began where the last one ended; charges it to `effect` where one is given.
  void finish(const char* name, std::optional<Effect> effect) {
    const Clock::time_point now = Clock::now();
    const double milliseconds = std::chrono::duration<double, std::milli>(now - start_).count();
    stats_.passesMs.emplace_back(name, milliseconds);
    if (effect) view_.effects->charge(*effect, 1e3 * milliseconds);
    start_ = now;
  }

 private:
  using Clock = std::chrono::steady_clock;
  const View& view_;
  FrameStats& stats_;
  Clock::time_point start_;
};

}  // namespace seaway::render
