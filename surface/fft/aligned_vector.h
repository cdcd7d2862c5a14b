#pragma once

#include <cstddef>
#include <new>
#include <vector>

namespace seaway {

/// Memory on boundaries of 64 bytes: a line of the cache, the longest vector.
template <class T>
struct AlignedAllocator {
  using value_type = T;
  AlignedAllocator() = default;
  template <class U>
  AlignedAllocator(const AlignedAllocator<U>&) {}
  T* allocate(std::size_t count) {
    return static_cast<T*>(::operator new(count * sizeof(T), std::align_val_t(64)));
  }
  void deallocate(T* values, std::size_t) { ::operator delete(values, std::align_val_t(64)); }
  bool operator==(const AlignedAllocator&) const { return true; }
};

template <class T>
using AlignedVector = std::vector<T, AlignedAllocator<T>>;

}  // namespace seaway
