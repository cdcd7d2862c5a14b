#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

#include "sim_bridge/cigi/codec.h"

/// Values in a datagram's bytes, which may lie at any address, in either byte order.
namespace seaway::bridge::cigi {

static_assert(std::endian::native == std::endian::little, "words are swapped for big-endian hosts");

inline std::uint8_t swapped(std::uint8_t word) { return word; }
inline std::uint16_t swapped(std::uint16_t word) { return __builtin_bswap16(word); }
inline std::uint32_t swapped(std::uint32_t word) { return __builtin_bswap32(word); }
inline std::uint64_t swapped(std::uint64_t word) { return __builtin_bswap64(word); }

template <std::size_t size>
using WordOfSize = std::conditional_t<
    size == 1, std::uint8_t,
    std::conditional_t<size == 2, std::uint16_t,
                       std::conditional_t<size == 4, std::uint32_t, std::uint64_t>>>;

template <class T>
T load(const std::byte* from, ByteOrder order) {
  WordOfSize<sizeof(T)> word;
  std::memcpy(&word, from, sizeof word);
  return std::bit_cast<T>(order == ByteOrder::bigEndian ? swapped(word) : word);
}

template <class T>
void store(T value, std::byte* to, ByteOrder order) {
  auto word = std::bit_cast<WordOfSize<sizeof(T)>>(value);
  if (order == ByteOrder::bigEndian) word = swapped(word);
  std::memcpy(to, &word, sizeof word);
}

}  // namespace seaway::bridge::cigi
