#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace seaway::bridge {

/// What a process that was run did.
struct ChildOutcome {
  int status = -1;        ///< exit status; -1 where a signal ended it
  int signal = 0;         ///< that ended it; 0: none
  bool timedOut = false;  ///< it was killed when its time was up
  double seconds = 0.0;   ///< wall time
  std::string out, err;   ///< what it wrote, at most 16 MiB each
};

/// What a process may use.
struct ChildLimits {
  std::chrono::milliseconds time{60'000};
  std::size_t memoryBytes = 0;  ///< of addresses; 0: no limit
  /// Asked again and again, where there is one, with what the process wrote to standard error; once
  /// it says true the process is sent SIGTERM.
  std::function<bool(const std::string& err)> isEnough{};
};

/// Runs `program`, standard input empty, and waits for its end. Any number may run at once. Throws
/// std::system_error where it cannot be started.
ChildOutcome runProgram(const std::filesystem::path& program,
                        const std::vector<std::string>& arguments, const ChildLimits& limits = {});

}  // namespace seaway::bridge
