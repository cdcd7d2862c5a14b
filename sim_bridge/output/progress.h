#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace seaway::bridge {

/// A progress bar on standard error: only where that is a terminal, and only once the work has
/// taken a second. Erased at the end.
class Progress {
 public:
  Progress(std::string label, std::size_t total);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void update(std::size_t done);

 private:
  using Clock = std::chrono::steady_clock;
  std::string label_;
  std::size_t total_;
  bool terminal_;
  bool shown_ = false;
  Clock::time_point next_;
};

}  // namespace seaway::bridge
