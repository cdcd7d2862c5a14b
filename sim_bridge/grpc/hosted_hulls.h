#pragma once

#include <cstdint>
#include <mutex>
#include <set>

namespace seaway::bridge::rpc {

/// The hulls that hosts of a service sail now. Thread-safe.
class HostedHulls {
 public:
  void add(std::uint32_t hull) {
    const std::lock_guard lock(mutex_);
    hulls_.insert(hull);
  }
  void remove(std::uint32_t hull) {
    const std::lock_guard lock(mutex_);
    hulls_.erase(hull);
  }
  bool has(std::uint32_t hull) const {
    const std::lock_guard lock(mutex_);
    return hulls_.contains(hull);
  }
  std::size_t size() const {
    const std::lock_guard lock(mutex_);
    return hulls_.size();
  }

 private:
  mutable std::mutex mutex_;
  std::set<std::uint32_t> hulls_;
};

}  // namespace seaway::bridge::rpc
