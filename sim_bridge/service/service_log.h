#pragma once

#include <cstdint>
#include <string>

namespace seaway::bridge {

/// How a service writes its messages on standard error: `text`, or `json`, one object a line with
/// `time` (UTC, ISO 8601), `level` and `message`. Messages are counted from now on. Throws
/// InputError, which begins with `option`, for another word.
void beginServiceLog(const std::string& option, const std::string& format);

struct LogCounts {
  std::uint64_t warnings = 0;
  std::uint64_t errors = 0;
};
/// Since beginServiceLog. Thread-safe.
LogCounts logCounts();

}  // namespace seaway::bridge
