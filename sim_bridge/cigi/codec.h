#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "sim_bridge/cigi/packets.h"

namespace seaway::bridge::cigi {

enum class Version : std::uint8_t { v33, v40 };
enum class ByteOrder : std::uint8_t { littleEndian, bigEndian };

/// How a partner writes.
struct Dialect {
  Version version = Version::v33;
  ByteOrder order = ByteOrder::littleEndian;
  bool operator==(const Dialect&) const = default;
};

/// Why a datagram is no message.
enum class Fault : std::uint8_t {
  none,
  tooShort,        ///< shorter than the packet that must come first
  unknownVersion,  ///< neither 3.3 (or 3.2, which is the same here) nor 4.0
  noFirstPacket,   ///< begins with neither IG Control nor Start of Frame
  zeroSize,        ///< a packet of size 0
  oddSize,         ///< a packet whose size is no multiple of 8
  overrun,         ///< a packet that goes on beyond the datagram's end
};
const char* faultText(Fault fault);

using Bytes = std::span<const std::byte>;

/// A datagram found whole: every packet's size fits. A range of packets, the first included.
class Message {
 public:
  /// One packet as it lies in the datagram.
  struct View {
    std::uint16_t id = 0;
    Bytes bytes;
  };
  class Iterator {
   public:
    Iterator(Bytes rest, Dialect dialect) : rest_(rest), dialect_(dialect) {}
    View operator*() const;
    Iterator& operator++();
    bool operator!=(const Iterator& other) const { return rest_.size() != other.rest_.size(); }

   private:
    Bytes rest_;
    Dialect dialect_;
  };

  Dialect dialect() const { return dialect_; }
  Iterator begin() const { return {bytes_, dialect_}; }
  Iterator end() const { return {bytes_.last(0), dialect_}; }

 private:
  friend Fault readMessage(Bytes datagram, std::optional<Message>& message) noexcept;
  Message(Bytes bytes, Dialect dialect) : bytes_(bytes), dialect_(dialect) {}
  Bytes bytes_;
  Dialect dialect_;
};

/// Finds version and byte order of `datagram` and checks the sizes of all its packets. Fills
/// `message`, which refers to the datagram, if and only if there is no fault. Reads nothing beyond
/// the datagram whatever is in it.
Fault readMessage(Bytes datagram, std::optional<Message>& message) noexcept;

enum class Decoded : std::uint8_t {
  known,
  unknown,    ///< an identifier not in the tables: to be passed over
  wrongSize,  ///< a known identifier with a size that is not the version's
};

/// Reads a packet of a message.
Decoded decode(Dialect dialect, const Message::View& view, Packet& packet) noexcept;

/// Writes a packet to the front of `out`; returns its size in bytes, 0 where `out` is too small or
/// the version has no such packet. Values wider than their bits lose their upper bits.
std::size_t encode(Dialect dialect, const Packet& packet, std::span<std::byte> out) noexcept;

/// The standard's name of a kind of packet.
const char* packetName(const Packet& packet) noexcept;

}  // namespace seaway::bridge::cigi
