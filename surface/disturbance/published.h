#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <memory>
#include <thread>
#include <utility>

namespace seaway {

/// The latest of a series of immutable values, handed from one writer to any number of readers.
///
/// Readers are lock-free: they never wait for the writer, and repeat themselves only when it has
/// published in between. The writer waits for a reader only where eight of them at once stand in
/// the middle of `latest`. A value lives as long as somebody holds it.
template <class T>
class Published {
 public:
  using Value = std::shared_ptr<const T>;

  /// The value published last; null before the first. Any thread.
  Value latest() const noexcept {
    for (;;) {
      Slot& slot = slots_[current_.load()];
      slot.readers.fetch_add(1);
      // Published again meanwhile? Then the slot may be written to: leave it alone.
      if (&slot == &slots_[current_.load()]) {
        Value value = slot.value;
        slot.readers.fetch_sub(1);
        return value;
      }
      slot.readers.fetch_sub(1);
    }
  }

  /// One thread at a time.
  void publish(Value value) {
    const std::size_t current = current_.load();
    for (std::size_t i = 0;; ++i) {
      const std::size_t next = (current + 1 + i) % slots_.size();
      // No reader: who comes later finds that the slot is not current. All atomics are sequentially
      // consistent, so one of the two sees the other.
      if (next == current || slots_[next].readers.load() != 0) {
        if (next == current) std::this_thread::yield();
        continue;
      }
      slots_[next].value = std::move(value);
      current_.store(next);
      return clearOthers(next);
    }
  }

 private:
  struct alignas(64) Slot {
    std::atomic<int> readers{0};
    Value value;
  };

  /// Lets go of older values that nobody reads, so that they do not live in here.
  void clearOthers(std::size_t current) {
    for (std::size_t i = 0; i < slots_.size(); ++i) {
      if (i != current && slots_[i].readers.load() == 0) slots_[i].value.reset();
    }
  }

  mutable std::array<Slot, 9> slots_;
  std::atomic<std::size_t> current_{0};
};

}  // namespace seaway
