#pragma once

#include <cstdint>
#include <variant>

namespace seaway::bridge::cigi {

/// Where a value stands in a packet: a byte offset, and for parts of a byte which bits of it.
struct Spot {
  std::int8_t offset = -1;  ///< −1: the version has no such value
  std::uint8_t shift = 0;
  std::uint8_t bits = 0;  ///< 0: all of the value's own size
};

constexpr Spot at(int offset) { return {static_cast<std::int8_t>(offset)}; }
constexpr Spot bits(int offset, int shift, int count = 1) {
  return {static_cast<std::int8_t>(offset), static_cast<std::uint8_t>(shift),
          static_cast<std::uint8_t>(count)};
}
inline constexpr Spot absent{};

/// A value that the standard fixes: written, and passed over in reading.
template <class Word>
struct Fixed {
  Word v33, v40;
};

/// One value of packet `P`: its member, its unit and where each version keeps it. A float, a double
/// or an integer of more than a byte has a spot of its own; bools are bits.
template <class P>
struct Field {
  using Member = std::variant<bool P::*, std::int8_t P::*, std::uint8_t P::*, std::uint16_t P::*,
                              std::uint32_t P::*, float P::*, double P::*, Fixed<std::uint8_t>,
                              Fixed<std::uint16_t>>;
  const char* name;
  const char* unit;  ///< "" where there is none
  Member member;
  Spot v33, v40;
};

/// How a version names a kind of packet, and its length in bytes; a size of 0: it has none.
struct Head {
  std::uint16_t id = 0;
  std::uint16_t size = 0;
};
inline constexpr Head noPacket{};

}  // namespace seaway::bridge::cigi
