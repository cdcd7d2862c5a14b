#include "sim_bridge/service/serve_clock.h"

#include <charconv>

#include "surface/input_error.h"

namespace seaway::bridge {

ServeClock ServeClock::parse(const std::string& option, const std::string& text) {
  if (text == "host") return ServeClock(0.0);
  if (text == "real") return ServeClock(1.0);
  constexpr double fastest = 1e6;
  double speed = 0.0;
  const char* end = text.data() + text.size();
  if (text.starts_with('x')) {
    const auto read = std::from_chars(text.data() + 1, end, speed);
    if (read.ec == std::errc{} && read.ptr == end && speed > 0.0 && speed <= fastest) {
      return ServeClock(speed);
    }
  }
  throw InputError(option + ": '" + text +
                   "' is not allowed; must be host, real, or xN with N in (0, 1e6]");
}

}  // namespace seaway::bridge
