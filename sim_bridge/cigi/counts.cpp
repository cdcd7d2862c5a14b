#include "sim_bridge/cigi/counts.h"

namespace seaway::bridge::cigi {

const char* Counts::name(Count which) {
  static constexpr std::array<const char*, size()> names{
      "datagrams",    "answers",          "heights",         "velocities", "invalid_points",
      "malformed",    "unexpected",       "unknown_packets", "wrong_size", "unsupported",
      "other_scopes", "refused_requests", "no_conditions",   "lost",       "late",
      "repeated",     "restarts",         "refused_hosts",   "unsent"};
  return names[static_cast<std::size_t>(which)];
}

}  // namespace seaway::bridge::cigi
