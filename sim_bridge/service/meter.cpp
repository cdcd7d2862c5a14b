#include "sim_bridge/service/meter.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace seaway::bridge {
namespace {

/// Renard's series R10: it holds 1, 2 and 5.
constexpr std::array<double, 10> preferred{1.0, 1.25, 1.6, 2.0, 2.5, 3.15, 4.0, 5.0, 6.3, 8.0};

const std::array<double, LatencyCounts::buckets>& upperEnds() {
  static const auto ends = [] {
    std::array<double, LatencyCounts::buckets> all{};
    for (std::size_t i = 0; i + 1 < all.size(); ++i) {
      all[i] = preferred[i % 10] * std::pow(10.0, static_cast<double>(i / 10)) / 1e6;
    }
    all.back() = std::numeric_limits<double>::infinity();
    return all;
  }();
  return ends;
}

}  // namespace

const char* refusalName(Refusal why) {
  static constexpr std::array<const char*, static_cast<std::size_t>(Refusal::count_)> names{
      "malformed", "too_large", "not_authorised", "not_found", "bad_value", "too_late", "failed"};
  return names[static_cast<std::size_t>(why)];
}

double LatencyCounts::upperEnd(std::size_t bucket) { return upperEnds()[bucket]; }

std::uint64_t LatencyCounts::total() const {
  return std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
}

double LatencyCounts::quantile(double part) const {
  const std::uint64_t all = total();
  if (all == 0) return 0.0;
  const auto wanted = static_cast<std::uint64_t>(std::ceil(part * static_cast<double>(all)));
  std::uint64_t below = 0;
  for (std::size_t i = 0; i + 1 < buckets; ++i) {
    below += counts[i];
    if (below >= std::max<std::uint64_t>(wanted, 1)) return upperEnd(i);
  }
  return upperEnd(buckets - 2);
}

LatencyCounts LatencyCounts::since(const LatencyCounts& before) const {
  LatencyCounts result = *this;
  for (std::size_t i = 0; i < buckets; ++i) result.counts[i] -= before.counts[i];
  result.sum -= before.sum;
  return result;
}

void LatencyMeter::add(double seconds) noexcept {
  const auto& ends = upperEnds();
  const auto found = std::lower_bound(ends.begin(), ends.end() - 1, seconds);
  counts_[static_cast<std::size_t>(found - ends.begin())].fetch_add(1, std::memory_order_relaxed);
  if (seconds > 0.0) {
    nanoseconds_.fetch_add(static_cast<std::uint64_t>(std::min(seconds, 1e6) * 1e9),
                           std::memory_order_relaxed);
  }
}

LatencyCounts LatencyMeter::read() const {
  LatencyCounts result;
  for (std::size_t i = 0; i < counts_.size(); ++i) {
    result.counts[i] = counts_[i].load(std::memory_order_relaxed);
  }
  result.sum = 1e-9 * static_cast<double>(nanoseconds_.load(std::memory_order_relaxed));
  return result;
}

MeterCounts Meter::read() const {
  MeterCounts result;
  result.requests = requests_.read();
  result.frames = frames_.read();
  result.points = points_.load(std::memory_order_relaxed);
  for (std::size_t i = 0; i < refusals_.size(); ++i) {
    result.refusals[i] = refusals_[i].load(std::memory_order_relaxed);
  }
  return result;
}

Meter& Meters::of(const std::string& endpoint) {
  const std::lock_guard lock(mutex_);
  return meters_[endpoint];
}

std::vector<std::pair<std::string, MeterCounts>> Meters::read() const {
  const std::lock_guard lock(mutex_);
  std::vector<std::pair<std::string, MeterCounts>> all;
  for (const auto& [name, meter] : meters_) all.emplace_back(name, meter.read());
  return all;
}

void Meters::addEvents(const std::string& endpoint, Events events) {
  const std::lock_guard lock(mutex_);
  events_[endpoint] = std::move(events);
}

std::vector<Meters::Event> Meters::readEvents() const {
  const std::lock_guard lock(mutex_);
  std::vector<Event> all;
  for (const auto& [endpoint, events] : events_) {
    for (auto& [name, count] : events()) all.push_back({endpoint, name, count});
  }
  return all;
}

}  // namespace seaway::bridge
