#pragma once

#include <random>
#include <type_traits>
#include <utility>
#include <vector>

#include "sim_bridge/cigi/codec.h"
#include "sim_bridge/cigi/packet_layouts.h"

namespace seaway::bridge::cigi::test {

/// Calls `action` with a value-initialised packet of each kind.
template <class Action>
void forEachKind(Action action) {
  [&]<std::size_t... i>(std::index_sequence<i...>) {
    (action(std::variant_alternative_t<i, Packet>{}), ...);
  }
  (std::make_index_sequence<std::variant_size_v<Packet>>{});
}

template <class P>
Head headOf(Version version) {
  return version == Version::v33 ? Layout<P>::v33 : Layout<P>::v40;
}

/// A packet whose values, those that `version` has, are random within their bits.
/// Not inlined: GCC 12 else takes members of packets for uninitialised.
template <class P>
[[gnu::noinline]] P randomPacket(Version version, std::mt19937& random) {
  P packet;
  for (const Field<P>& field : Layout<P>::fields) {
    const Spot spot = version == Version::v33 ? field.v33 : field.v40;
    if (spot.offset < 0) continue;
    const unsigned mask = spot.bits == 0 ? ~0u : (1u << spot.bits) - 1u;
    std::visit(
        [&]<class M>(const M& member) {
          if constexpr (std::is_member_object_pointer_v<M>) {
            using T = std::remove_reference_t<decltype(packet.*member)>;
            if constexpr (std::is_floating_point_v<T>) {
              packet.*member =
                  static_cast<T>(std::uniform_real_distribution(-180.0, 180.0)(random));
            } else {
              packet.*member = static_cast<T>(random() & mask);
            }
          }
        },
        field.member);
  }
  return packet;
}

/// Whether two packets agree in every value.
template <class P>
[[gnu::noinline]] bool sameValues(const P& a, const P& b) {
  bool same = true;
  for (const Field<P>& field : Layout<P>::fields) {
    std::visit(
        [&]<class M>(const M& member) {
          if constexpr (std::is_member_object_pointer_v<M>) same &= a.*member == b.*member;
        },
        field.member);
  }
  return same;
}

inline constexpr Dialect allDialects[] = {{Version::v33, ByteOrder::littleEndian},
                                          {Version::v33, ByteOrder::bigEndian},
                                          {Version::v40, ByteOrder::littleEndian},
                                          {Version::v40, ByteOrder::bigEndian}};

/// A datagram of some packets.
inline std::vector<std::byte> datagramOf(Dialect dialect, const std::vector<Packet>& packets) {
  std::vector<std::byte> datagram;
  for (const Packet& packet : packets) {
    std::byte bytes[64];
    const std::size_t size = encode(dialect, packet, bytes);
    datagram.insert(datagram.end(), bytes, bytes + size);
  }
  return datagram;
}

/// A host's datagram with one random packet of each kind that the version has.
inline std::vector<std::byte> everyKind(Dialect dialect, std::mt19937& random) {
  std::vector<Packet> packets{IgControl{}};
  forEachKind([&]<class P>(P) { packets.push_back(randomPacket<P>(dialect.version, random)); });
  return datagramOf(dialect, packets);
}

/// The packets of a datagram; empty where it is none.
inline std::vector<Packet> packetsOf(Bytes datagram) {
  std::vector<Packet> packets;
  std::optional<Message> message;
  if (readMessage(datagram, message) != Fault::none) return packets;
  for (const Message::View view : *message) {
    Packet packet;
    if (decode(message->dialect(), view, packet) == Decoded::known) packets.push_back(packet);
  }
  return packets;
}

/// The packets of one kind.
template <class P>
std::vector<P> packetsOf(Bytes datagram) {
  std::vector<P> found;
  for (const Packet& packet : packetsOf(datagram)) {
    if (const P* is = std::get_if<P>(&packet)) found.push_back(*is);
  }
  return found;
}

}  // namespace seaway::bridge::cigi::test
