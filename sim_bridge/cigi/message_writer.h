#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "sim_bridge/cigi/codec.h"

namespace seaway::bridge::cigi {

/// Writes what goes to a host: datagrams that each begin with the same Start of Frame. Keeps its
/// memory from one message to the next.
class MessageWriter {
 public:
  /// `largest` ≥ 64 bytes a datagram.
  explicit MessageWriter(std::size_t largest) : largest_(largest) {}

  /// Begins anew, in a dialect.
  void begin(Dialect dialect, const StartOfFrame& start);
  /// Goes on in a further datagram where this one is full. Packets that the version lacks are left
  /// out.
  void add(const Packet& packet);

  std::size_t size() const { return used_; }
  Bytes operator[](std::size_t i) const { return datagrams_[i]; }

 private:
  void open();

  std::size_t largest_;
  Dialect dialect_;
  Packet start_;
  std::vector<std::vector<std::byte>> datagrams_;
  std::size_t used_ = 0;
};

}  // namespace seaway::bridge::cigi
