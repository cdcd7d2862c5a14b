#include "sim_bridge/cost/study.h"

#include <algorithm>
#include <chrono>

namespace seaway::bridge {

Timing timeRepeated(const std::function<void()>& work, int repetitions) {
  using Clock = std::chrono::steady_clock;
  std::vector<double> seconds;
  work();
  for (int i = 0; i < repetitions; ++i) {
    const auto start = Clock::now();
    work();
    seconds.push_back(std::chrono::duration<double>(Clock::now() - start).count());
  }
  std::sort(seconds.begin(), seconds.end());
  const auto at = [&](double share) {
    return seconds[static_cast<std::size_t>(share * static_cast<double>(seconds.size() - 1) + 0.5)];
  };
  return {at(0.5), 0.5 * (at(0.75) - at(0.25))};
}

}  // namespace seaway::bridge
