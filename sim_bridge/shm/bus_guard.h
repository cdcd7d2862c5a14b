#pragma once

#include <atomic>
#include <cstddef>

namespace seaway::bridge::shm {

/// Keeps the process alive when memory that is mapped from a file goes away: a host may cut the
/// shared file short, or the machine's shared memory may be used up, and the next access is a
/// SIGBUS. The guarded range then becomes private zeros, and `broken` tells. Other SIGBUS go to the
/// handler that was there before. Thread-safe; at most 16 guards at a time (std::runtime_error).
class BusGuard {
 public:
  /// `memory` is a whole mapping of `size` bytes, which outlives the guard.
  BusGuard(void* memory, std::size_t size);
  ~BusGuard();
  BusGuard(const BusGuard&) = delete;
  BusGuard& operator=(const BusGuard&) = delete;

  bool broken() const noexcept;

  /// For the handler.
  struct Range;

 private:
  Range* range_;
};

}  // namespace seaway::bridge::shm
