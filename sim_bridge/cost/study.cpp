#include "sim_bridge/cost/study.h"

#include <algorithm>
#include <chrono>
#include <fstream>
#include <thread>

namespace seaway::bridge {

std::string machineLine() {
  std::string model = "an unnamed processor";
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    const std::size_t colon = line.find(": ");
    if (line.rfind("model name", 0) == 0 && colon != line.npos) {
      model = line.substr(colon + 2);
      break;
    }
  }
  return model + ", " + std::to_string(std::thread::hardware_concurrency()) + " threads";
}

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
