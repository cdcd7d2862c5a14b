#include "sim_bridge/cost/study.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <limits>
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

namespace {

Timing timingOf(std::vector<double>& seconds) {
  std::sort(seconds.begin(), seconds.end());
  const auto at = [&](double share) {
    return seconds[static_cast<std::size_t>(share * static_cast<double>(seconds.size() - 1) + 0.5)];
  };
  return {at(0.5), 0.5 * (at(0.75) - at(0.25))};
}

}  // namespace

Timing timeRepeated(const std::function<void()>& work, int repetitions) {
  return timeByTurns({work}, repetitions).front();
}

std::vector<Timing> timeByTurns(const std::vector<std::function<void()>>& works, int repetitions) {
  using Clock = std::chrono::steady_clock;
  for (const auto& work : works) work();
  std::vector<std::vector<double>> seconds(works.size());
  for (int i = 0; i < repetitions; ++i) {
    for (std::size_t k = 0; k < works.size(); ++k) {
      const auto start = Clock::now();
      works[k]();
      seconds[k].push_back(std::chrono::duration<double>(Clock::now() - start).count());
    }
  }
  std::vector<Timing> timings;
  for (std::vector<double>& each : seconds) timings.push_back(timingOf(each));
  return timings;
}

std::vector<CostPoint> paretoFront(std::vector<CostPoint> points) {
  std::erase_if(points, [](const CostPoint& point) { return std::isnan(point.error); });
  std::stable_sort(points.begin(), points.end(), [](const CostPoint& a, const CostPoint& b) {
    return a.cost != b.cost ? a.cost < b.cost : a.error < b.error;
  });
  double least = std::numeric_limits<double>::infinity();
  std::erase_if(points, [&](const CostPoint& point) {
    if (!(point.error < least)) return true;
    least = point.error;
    return false;
  });
  return points;
}

}  // namespace seaway::bridge
