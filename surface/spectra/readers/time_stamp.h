#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>

namespace seaway {

/// ISO 8601 text of a UTC date and time, `2020-06-08T03:50Z`, with seconds only where they are not
/// 0; nothing for what is no date and time.
std::optional<std::string> isoTime(int year, int month, int day, int hour, int minute,
                                   int second = 0);

/// The moment of `2020-06-08T03:50`, with optional `:SS`, fraction of a second (dropped) and `Z`;
/// nothing for anything else.
std::optional<std::chrono::sys_seconds> parseIsoTime(std::string_view text);

/// The ISO text of a moment.
std::string isoTime(std::chrono::sys_seconds moment);

}  // namespace seaway
