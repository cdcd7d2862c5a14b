#include "sim_bridge/cigi/message_writer.h"

namespace seaway::bridge::cigi {
namespace {

/// No packet of ours is longer.
constexpr std::size_t longestPacket = 48;

std::size_t append(Dialect dialect, const Packet& packet, std::vector<std::byte>& datagram) {
  const std::size_t before = datagram.size();
  datagram.resize(before + longestPacket);
  const std::size_t size = encode(dialect, packet, std::span(datagram).subspan(before));
  datagram.resize(before + size);
  return size;
}

}  // namespace

void MessageWriter::begin(Dialect dialect, const StartOfFrame& start) {
  dialect_ = dialect;
  start_ = start;
  used_ = 0;
  open();
}

void MessageWriter::open() {
  if (used_ == datagrams_.size()) datagrams_.emplace_back();
  std::vector<std::byte>& datagram = datagrams_[used_++];
  datagram.clear();
  datagram.reserve(largest_ + longestPacket);
  append(dialect_, start_, datagram);
}

void MessageWriter::add(const Packet& packet) {
  std::vector<std::byte>& last = datagrams_[used_ - 1];
  const std::size_t size = append(dialect_, packet, last);
  if (last.size() <= largest_) return;
  last.resize(last.size() - size);
  open();
  append(dialect_, packet, datagrams_[used_ - 1]);
}

}  // namespace seaway::bridge::cigi
