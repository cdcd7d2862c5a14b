#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

namespace seaway::bridge::cigi {

/// What a CIGI service counts.
enum class Count : std::size_t {
  datagrams,        ///< received
  answers,          ///< datagrams sent
  heights,          ///< points whose height was asked for
  velocities,       ///< points whose water velocity was asked for
  invalidPoints,    ///< of those, answered as not valid: ashore, out of range, of no entity
  malformed,        ///< datagrams dropped: no message
  unexpected,       ///< datagrams dropped: a message of an image generator
  unknownPackets,   ///< passed over: an identifier that is not served
  wrongSize,        ///< packets passed over: a known identifier of another size
  unsupported,      ///< packets passed over: not finite, waves that cannot be, other conditions
  otherScopes,      ///< packets passed over: of a region or an entity, where there is one sea state
  refusedRequests,  ///< more requests at a time than are kept
  noConditions,     ///< maritime conditions asked where there is no water: not answered
  lost,             ///< host frames that never came, or came late
  late,             ///< datagrams dropped: older than one already served
  repeated,         ///< datagrams that came again
  restarts,         ///< hosts that began again
  refusedHosts,     ///< datagrams dropped: more hosts than are served at a time
  unsent,           ///< answers that the network would not take
  count_
};

/// A number for every Count. Thread-safe.
class Counts {
 public:
  /// Returns whether this is the first of its kind.
  bool add(Count which, std::uint64_t many = 1) {
    return counts_[static_cast<std::size_t>(which)].fetch_add(many, std::memory_order_relaxed) == 0;
  }
  std::uint64_t operator[](Count which) const {
    return counts_[static_cast<std::size_t>(which)].load(std::memory_order_relaxed);
  }

  static constexpr std::size_t size() { return static_cast<std::size_t>(Count::count_); }
  /// As in a metric's label: `refused_hosts`.
  static const char* name(Count which);

 private:
  std::array<std::atomic<std::uint64_t>, static_cast<std::size_t>(Count::count_)> counts_{};
};

}  // namespace seaway::bridge::cigi
