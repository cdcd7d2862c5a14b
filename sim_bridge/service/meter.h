#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace seaway::bridge {

/// Why a request was not answered.
enum class Refusal : std::size_t {
  malformed,      ///< no request at all
  tooLarge,       ///< more points, hosts, or a longer message, than is served
  notAuthorised,  ///< no token, or a wrong one
  notFound,       ///< no such hull, camera, page, method
  badValue,       ///< a value that is not allowed
  tooLate,        ///< its deadline had passed
  failed,         ///< a fault of ours
  count_
};
/// As in a metric's label: `too_large`.
const char* refusalName(Refusal why);

/// How long things took: a histogram whose buckets end at 1, 1.25, 1.6, 2, 2.5, 3.15, 4, 5, 6.3, 8
/// … µs, up to 10 s, and one for what took longer.
struct LatencyCounts {
  static constexpr std::size_t buckets = 72;
  /// Upper end of a bucket, s; infinite for the last.
  static double upperEnd(std::size_t bucket);

  std::array<std::uint64_t, buckets> counts{};
  double sum = 0.0;  ///< s, to a nanosecond each

  std::uint64_t total() const;
  /// The time that a part of all, in (0, 1], did not exceed, within its bucket's width (25 %), s; 0
  /// where there is none.
  double quantile(double part) const;
  /// What has come since `before`.
  LatencyCounts since(const LatencyCounts& before) const;
};

/// LatencyCounts that threads add to without locks.
class LatencyMeter {
 public:
  void add(double seconds) noexcept;
  LatencyCounts read() const;

 private:
  std::array<std::atomic<std::uint64_t>, LatencyCounts::buckets> counts_{};
  std::atomic<std::uint64_t> nanoseconds_{0};
};

/// What a Meter has counted.
struct MeterCounts {
  LatencyCounts requests;  ///< answered, and how long that took
  LatencyCounts frames;
  std::uint64_t points = 0;
  std::array<std::uint64_t, static_cast<std::size_t>(Refusal::count_)> refusals{};
};

/// Lock-free counts of one endpoint. Thread-safe.
class Meter {
 public:
  /// A request with so many points was answered in so many seconds.
  void answered(std::size_t points, double seconds) noexcept {
    requests_.add(seconds);
    points_.fetch_add(points, std::memory_order_relaxed);
  }
  void refused(Refusal why) noexcept {
    refusals_[static_cast<std::size_t>(why)].fetch_add(1, std::memory_order_relaxed);
  }
  /// A picture was drawn and sent in so many seconds.
  void frameSent(double seconds) noexcept { frames_.add(seconds); }

  MeterCounts read() const;

 private:
  LatencyMeter requests_, frames_;
  std::atomic<std::uint64_t> points_{0};
  std::array<std::atomic<std::uint64_t>, static_cast<std::size_t>(Refusal::count_)> refusals_{};
};

/// The meters of a service, by endpoint. Thread-safe.
class Meters {
 public:
  /// Made on first use; stays where it is. An endpoint asks once, not for every request.
  Meter& of(const std::string& endpoint);
  /// All there are, by name.
  std::vector<std::pair<std::string, MeterCounts>> read() const;

  /// What an endpoint counts beside, by name; thread-safe, and there for as long as these meters
  /// are read.
  using Events = std::function<std::vector<std::pair<std::string, std::uint64_t>>()>;
  void addEvents(const std::string& endpoint, Events events);
  struct Event {
    std::string endpoint, name;
    std::uint64_t count;
  };
  std::vector<Event> readEvents() const;

 private:
  mutable std::mutex mutex_;
  std::map<std::string, Events> events_;
  std::map<std::string, Meter> meters_;
};

}  // namespace seaway::bridge
