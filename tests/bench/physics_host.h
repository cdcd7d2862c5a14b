#pragma once

#include <sched.h>
#include <sys/mman.h>
#include <sys/types.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

namespace seaway::bench {

struct PhysicsHostOptions {
  double seconds = 10.0;
  double period = 1e-3;  ///< s
  int fifo = 0;          ///< priority of SCHED_FIFO; 0: as it is
};

inline double monotonicSeconds() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

inline void sleepUntil(double when) {
  timespec at{};
  at.tv_sec = static_cast<time_t>(when);
  at.tv_nsec = static_cast<long>(1e9 * (when - static_cast<double>(at.tv_sec)));
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &at, nullptr) != 0) {
  }
}

/// All threads of a process; false, and why is printed, where that is not permitted.
inline bool scheduleFifo(pid_t process, int priority) {
  sched_param parameters{};
  parameters.sched_priority = priority;
  const std::filesystem::path tasks("/proc/" + std::to_string(process) + "/task");
  for (const auto& task : std::filesystem::directory_iterator(tasks)) {
    if (sched_setscheduler(std::stoi(task.path().filename()), SCHED_FIFO, &parameters) != 0) {
      std::printf("SCHED_FIFO is not permitted (%s): as any other process\n", std::strerror(errno));
      return false;
    }
  }
  return true;
}

inline double residentMiB(pid_t process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/statm");
  double all = 0.0, resident = 0.0;
  file >> all >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1048576.0;
}

/// How often the scheduler took the processor from threads of a process that were not done.
inline std::uint64_t preemptions(pid_t process) {
  const std::string word = "nonvoluntary_ctxt_switches:";
  std::uint64_t sum = 0;
  const std::filesystem::path tasks("/proc/" + std::to_string(process) + "/task");
  for (const auto& task : std::filesystem::directory_iterator(tasks)) {
    std::ifstream file(task.path() / "status");
    for (std::string line; std::getline(file, line);) {
      if (line.starts_with(word)) sum += std::stoull(line.substr(word.size()));
    }
  }
  return sum;
}

/// Counts of times in buckets of 2 %, from 0.1 us to 10 s: as much memory at the end as at first.
class TimeCounts {
 public:
  void add(double seconds) {
    const double place = std::log(std::max(seconds, least) / least) / std::log(ratio);
    ++counts_[std::min(static_cast<std::size_t>(place), counts_.size() - 1)];
    ++all_;
    longest_ = std::max(longest_, seconds);
  }
  std::uint64_t all() const { return all_; }
  double longest() const { return longest_; }
  /// Within 2 %, s.
  double quantile(double part) const {
    const auto wanted = static_cast<std::uint64_t>(std::ceil(part * static_cast<double>(all_)));
    std::uint64_t seen = 0;
    for (std::size_t i = 0; i < counts_.size(); ++i) {
      seen += counts_[i];
      if (seen >= wanted && seen > 0) return std::min(longest_, least * std::pow(ratio, i + 1.0));
    }
    return longest_;
  }

 private:
  static constexpr double least = 1e-7, ratio = 1.02;
  std::array<std::uint64_t, 931> counts_{};
  std::uint64_t all_ = 0;
  double longest_ = 0.0;
};

/// What became of one kind of tick.
struct Ticks {
  const char* name;
  TimeCounts woken = {}, worked = {}, done = {};  // after the tick; of the work; after the tick
  std::uint64_t missed = 0;                       // done after the next tick
  std::uint64_t wokenLate = 0;                    // of those, woken after half a period
  std::uint64_t preempted = 0;                    // of the others, somebody was preempted lately
  std::uint64_t sleptThrough = 0;

  void print() const {
    const auto line = [&](const char* what, const TimeCounts& times) {
      std::printf("%-16s %-10s %9.1f %9.1f %9.1f %9.1f %9.1f\n", name, what,
                  1e6 * times.quantile(0.5), 1e6 * times.quantile(0.99),
                  1e6 * times.quantile(0.999), 1e6 * times.quantile(0.9999), 1e6 * times.longest());
    };
    line("woken", woken);
    line("work", worked);
    line("done", done);
  }
  void printMissed() const {
    const std::uint64_t rest = missed - wokenLate - preempted;
    std::printf(
        "%-16s %llu ticks, %llu done after the next: %llu woken late, %llu with a "
        "preemption within a second, %llu neither; %llu ticks slept through\n",
        name, static_cast<unsigned long long>(done.all()), static_cast<unsigned long long>(missed),
        static_cast<unsigned long long>(wokenLate), static_cast<unsigned long long>(preempted),
        static_cast<unsigned long long>(rest), static_cast<unsigned long long>(sleptThrough));
  }
};

/// What a tick may do, and the process that answers; 0: nobody else.
struct HostWork {
  const char* name;
  std::function<void()> run;
  pid_t server = 0;
};

/// A physics engine's loop: wakes each period and works. Seconds of each kind of work take turns:
/// what they do not share is their own. Tells the memory of the first one's server.
inline void runPhysicsHost(const PhysicsHostOptions& options, const std::vector<HostWork>& works) {
  mlockall(MCL_CURRENT);  // where permitted
  std::vector<pid_t> processes{getpid()};
  for (const HostWork& work : works) {
    if (work.server != 0) processes.push_back(work.server);
  }
  if (options.fifo > 0) {
    for (const pid_t process : processes) scheduleFifo(process, options.fifo);
  }
  std::vector<Ticks> all;
  for (const HostWork& work : works) {
    all.push_back({work.name});
    for (int i = 0; i < 1000; ++i) work.run();
  }
  const pid_t server = works.front().server;
  const double serverMemory = residentMiB(server), ownMemory = residentMiB(getpid());
  double mostMemory = serverMemory;
  const auto allPreemptions = [&] {
    std::uint64_t sum = 0;
    for (const pid_t process : processes) sum += preemptions(process);
    return sum;
  };
  std::uint64_t seen = allPreemptions();
  const auto wasPreempted = [&] {
    const std::uint64_t before = seen;
    seen = allPreemptions();
    return seen != before;
  };
  const double start = monotonicSeconds();
  const auto perSecond = static_cast<std::uint64_t>(std::lround(1.0 / options.period));
  const auto count = static_cast<std::uint64_t>(options.seconds / options.period);
  for (std::uint64_t i = 1; i <= count; ++i) {
    const double tick = start + static_cast<double>(i) * options.period;
    const std::size_t kind = i / perSecond % works.size();
    Ticks& ticks = all[kind];
    if (monotonicSeconds() > tick + options.period) {
      ++ticks.sleptThrough;
      continue;
    }
    sleepUntil(tick);
    const double woken = monotonicSeconds();
    works[kind].run();
    const double done = monotonicSeconds();
    ticks.woken.add(woken - tick);
    ticks.worked.add(done - woken);
    ticks.done.add(done - tick);
    if (i % perSecond == 0) {
      wasPreempted();  // so that a preemption is laid to a tick near it
      mostMemory = std::max(mostMemory, residentMiB(server));
    }
    if (done <= tick + options.period) continue;
    ++ticks.missed;
    if (woken - tick > 0.5 * options.period) {
      ++ticks.wokenLate;
    } else if (wasPreempted()) {
      ++ticks.preempted;
    }
  }
  std::printf("%-16s %-10s %9s %9s %9s %9s %9s\n", "us", "", "median", "p99", "p99.9", "p99.99",
              "longest");
  for (const Ticks& each : all) each.print();
  for (const Ticks& each : all) each.printMissed();
  std::printf("resident MiB: server %.2f -> %.2f, at most %.2f; host %.2f -> %.2f\n", serverMemory,
              residentMiB(server), mostMemory, ownMemory, residentMiB(getpid()));
}

}  // namespace seaway::bench
