#include "sim_bridge/cigi/codec.h"

#include <algorithm>
#include <utility>

#include "sim_bridge/cigi/packet_layouts.h"
#include "sim_bridge/cigi/words.h"

namespace seaway::bridge::cigi {
namespace {

/// Every message begins with a packet of this size, in both versions.
constexpr std::size_t firstPacketSize = 24;

template <class Member>
struct Pointed;
template <class P, class T>
struct Pointed<T P::*> {
  using Type = T;
};
template <class Word>
struct Pointed<Fixed<Word>> {
  using Type = Word;
};

/// Whether a table's values lie within their packet, parts of bytes within one byte, and every
/// member has room for what it reads.
template <class P>
constexpr bool isSound(Head head, Spot Field<P>::*spotOf) {
  for (const Field<P>& field : Layout<P>::fields) {
    const Spot spot = field.*spotOf;
    if (spot.offset < 0) continue;
    if (head.size == 0) return false;
    const std::size_t size = std::visit(
        []<class M>(const M&) { return sizeof(typename Pointed<M>::Type); }, field.member);
    const bool isBool = std::holds_alternative<bool P::*>(field.member);
    if (isBool && spot.bits != 1) return false;
    if (spot.bits != 0 && (size != 1 || spot.shift + spot.bits > 8)) return false;
    if (spot.offset + size > head.size) return false;
  }
  return head.size % 8 == 0;
}

template <class P>
struct Checked {
  static_assert(isSound<P>(Layout<P>::v33, &Field<P>::v33));
  static_assert(isSound<P>(Layout<P>::v40, &Field<P>::v40));
  using L = Layout<P>;
};

template <class P>
Head headOf(Version version) {
  return version == Version::v33 ? Checked<P>::L::v33 : Checked<P>::L::v40;
}

constexpr unsigned maskOf(Spot spot) { return (1u << spot.bits) - 1u; }

template <class P>
void readFields(Dialect dialect, Bytes bytes, P& packet) {
  for (const Field<P>& field : Layout<P>::fields) {
    const Spot spot = dialect.version == Version::v33 ? field.v33 : field.v40;
    if (spot.offset < 0) continue;
    const std::byte* from = bytes.data() + spot.offset;
    std::visit(
        [&]<class M>(const M& member) {
          if constexpr (std::is_member_object_pointer_v<M>) {
            using T = typename Pointed<M>::Type;
            if (spot.bits == 0) {
              if constexpr (!std::is_same_v<T, bool>) {
                packet.*member = load<T>(from, dialect.order);
              }
            } else {
              packet.*member =
                  static_cast<T>((std::to_integer<unsigned>(*from) >> spot.shift) & maskOf(spot));
            }
          }
        },
        field.member);
  }
}

template <class P>
void writeFields(Dialect dialect, const P& packet, std::span<std::byte> out) {
  for (const Field<P>& field : Layout<P>::fields) {
    const bool v33 = dialect.version == Version::v33;
    const Spot spot = v33 ? field.v33 : field.v40;
    if (spot.offset < 0) continue;
    std::byte* to = out.data() + spot.offset;
    std::visit(
        [&]<class M>(const M& member) {
          using T = typename Pointed<M>::Type;
          T value;
          if constexpr (std::is_member_object_pointer_v<M>) {
            value = packet.*member;
          } else {
            value = v33 ? member.v33 : member.v40;
          }
          if (spot.bits != 0) {
            const unsigned part = (static_cast<unsigned>(value) & maskOf(spot)) << spot.shift;
            *to |= static_cast<std::byte>(part);
          } else if constexpr (!std::is_same_v<T, bool>) {
            store(value, to, dialect.order);
          }
        },
        field.member);
  }
}

struct Header {
  std::uint16_t id = 0;
  std::uint16_t size = 0;
};

constexpr std::size_t headerSize(Version version) { return version == Version::v33 ? 2 : 4; }

Header headerOf(Bytes bytes, Dialect dialect) {
  if (dialect.version == Version::v33) {
    return {load<std::uint8_t>(bytes.data(), dialect.order),
            load<std::uint8_t>(bytes.data() + 1, dialect.order)};
  }
  return {load<std::uint16_t>(bytes.data() + 2, dialect.order),
          load<std::uint16_t>(bytes.data(), dialect.order)};
}

void writeHeader(Dialect dialect, Head head, std::byte* to) {
  if (dialect.version == Version::v33) {
    store(static_cast<std::uint8_t>(head.id), to, dialect.order);
    store(static_cast<std::uint8_t>(head.size), to + 1, dialect.order);
  } else {
    store(head.size, to, dialect.order);
    store(head.id, to + 2, dialect.order);
  }
}

/// 3.x has its major version in byte 2 and, at offset 6, 0x8000 in the sender's byte order (2008's
/// 3.3 and 3.2 share their layouts). In 4.0 bytes 2 and 3 are the first packet's identifier, 0 or
/// 0xFFFF, and the size 24 tells the byte order.
std::optional<Dialect> dialectOf(Bytes datagram) {
  const auto byte = [&](std::size_t i) { return std::to_integer<unsigned>(datagram[i]); };
  if (byte(2) == 3) {
    const auto magic = load<std::uint16_t>(datagram.data() + 6, ByteOrder::littleEndian);
    if (magic == 0x8000) return Dialect{Version::v33, ByteOrder::littleEndian};
    if (magic == 0x0080) return Dialect{Version::v33, ByteOrder::bigEndian};
    return std::nullopt;
  }
  if ((byte(2) == 0x00 || byte(2) == 0xFF) && byte(4) == 4) {
    return Dialect{Version::v40, byte(0) == 0 ? ByteOrder::bigEndian : ByteOrder::littleEndian};
  }
  return std::nullopt;
}

bool beginsMessage(Header header, Version version) {
  const Head control = headOf<IgControl>(version);
  const Head start = headOf<StartOfFrame>(version);
  return (header.id == control.id && header.size == control.size) ||
         (header.id == start.id && header.size == start.size);
}

Fault faultOfSizes(Bytes rest, Dialect dialect) {
  while (!rest.empty()) {
    if (rest.size() < headerSize(dialect.version)) return Fault::overrun;
    const std::size_t size = headerOf(rest, dialect).size;
    if (size == 0) return Fault::zeroSize;
    if (size % 8 != 0) return Fault::oddSize;
    if (size > rest.size()) return Fault::overrun;
    rest = rest.subspan(size);
  }
  return Fault::none;
}

template <class P>
bool decodeAs(Dialect dialect, const Message::View& view, Packet& packet, Decoded& result) {
  const Head head = headOf<P>(dialect.version);
  if (head.size == 0 || head.id != view.id) return false;
  result = view.bytes.size() == head.size ? Decoded::known : Decoded::wrongSize;
  if (result == Decoded::known) readFields(dialect, view.bytes, packet.emplace<P>());
  return true;
}

}  // namespace

const char* faultText(Fault fault) {
  switch (fault) {
    case Fault::none:
      return "no fault";
    case Fault::tooShort:
      return "shorter than the packet that must come first";
    case Fault::unknownVersion:
      return "neither CIGI 3.2 or 3.3 nor 4.0";
    case Fault::noFirstPacket:
      return "begins with neither IG Control nor Start of Frame";
    case Fault::zeroSize:
      return "a packet has size 0";
    case Fault::oddSize:
      return "a packet's size is no multiple of 8";
    case Fault::overrun:
      return "a packet goes on beyond the datagram's end";
  }
  return "";
}

Fault readMessage(Bytes datagram, std::optional<Message>& message) noexcept {
  message.reset();
  if (datagram.size() < firstPacketSize) return Fault::tooShort;
  const std::optional<Dialect> dialect = dialectOf(datagram);
  if (!dialect) return Fault::unknownVersion;
  if (!beginsMessage(headerOf(datagram, *dialect), dialect->version)) return Fault::noFirstPacket;
  const Fault fault = faultOfSizes(datagram, *dialect);
  if (fault == Fault::none) message = Message(datagram, *dialect);
  return fault;
}

Message::View Message::Iterator::operator*() const {
  const Header header = headerOf(rest_, dialect_);
  return {header.id, rest_.first(header.size)};
}

Message::Iterator& Message::Iterator::operator++() {
  rest_ = rest_.subspan(headerOf(rest_, dialect_).size);
  return *this;
}

Decoded decode(Dialect dialect, const Message::View& view, Packet& packet) noexcept {
  Decoded result = Decoded::unknown;
  [&]<std::size_t... i>(std::index_sequence<i...>) {
    (decodeAs<std::variant_alternative_t<i, Packet>>(dialect, view, packet, result) || ...);
  }
  (std::make_index_sequence<std::variant_size_v<Packet>>{});
  return result;
}

std::size_t encode(Dialect dialect, const Packet& packet, std::span<std::byte> out) noexcept {
  return std::visit(
      [&]<class P>(const P& value) -> std::size_t {
        const Head head = headOf<P>(dialect.version);
        if (head.size == 0 || out.size() < head.size) return 0;
        std::fill_n(out.begin(), head.size, std::byte{0});
        writeHeader(dialect, head, out.data());
        writeFields(dialect, value, out);
        return head.size;
      },
      packet);
}

const char* packetName(const Packet& packet) noexcept {
  return std::visit([]<class P>(const P&) { return Layout<P>::name; }, packet);
}

}  // namespace seaway::bridge::cigi
