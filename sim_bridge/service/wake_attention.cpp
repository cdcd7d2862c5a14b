#include "sim_bridge/service/wake_attention.h"

#include <algorithm>
#include <cmath>

namespace seaway::bridge {
namespace {

constexpr double patch = 128.0;     // m
constexpr double epoch = 4.0;       // s
constexpr std::size_t most = 4096;  // patches: beyond, new ones wait until others are forgotten

std::int64_t cellOf(double value, double size) {
  return static_cast<std::int64_t>(std::floor(value / size));
}

}  // namespace

void WakeAttention::note(double t, const WakeListener& listener, Clock::time_point now) {
  const Key key{cellOf(listener.position.x, patch), cellOf(listener.position.y, patch),
                cellOf(t, epoch), listener.vessel};
  const auto found = heard_.find(key);
  if (found == heard_.end()) {
    if (heard_.size() < most) heard_[key] = {listener, t, now};
    return;
  }
  Heard& heard = found->second;
  heard.listener.position = listener.position;
  heard.listener.radius = std::max(heard.listener.radius, listener.radius);
  heard.time = std::max(heard.time, t);
  heard.when = now;
}

WakeAttention::Call WakeAttention::call(Clock::time_point now) {
  std::erase_if(heard_, [&](const auto& entry) { return now - entry.second.when > patience; });
  Call result;
  if (heard_.empty()) return result;
  result.time = std::max_element(heard_.begin(), heard_.end(), [](const auto& a, const auto& b) {
                  return a.second.time < b.second.time;
                })->second.time;
  for (const auto& [key, heard] : heard_) {
    // Those of another clock do not call for wakes where they are.
    if (heard.time > result.time - 2.0 * epoch) result.listeners.push_back(heard.listener);
  }
  return result;
}

}  // namespace seaway::bridge
