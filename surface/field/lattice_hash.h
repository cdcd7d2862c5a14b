#pragma once

#include <cstdint>

/// Integer hashing of lattice corners: the field's only source of randomness. Exact in 32-bit
/// integers, hence the same on every machine and in shaders.
namespace seaway {

/// Seeds of one octave, or of one time slice of it.
struct LatticeSeeds {
  std::uint32_t x;
  std::uint32_t y;
};

/// Constants of the hash. Kernels use them on premultiplied coordinates: a step of one cell along
/// an axis adds the axis' stride.
inline constexpr std::uint32_t latticeStrideX = 0x9E3779B1u;
inline constexpr std::uint32_t latticeStrideY = 0x85EBCA77u;
inline constexpr std::uint32_t latticeFirstFactor = 0x2C1B3C6Du;
inline constexpr std::uint32_t latticeSecondFactor = 0x297A2D39u;

/// Hash of lattice corner (i, j): two multiplications to mix the seeded coordinates, two to
/// spread them (one alone leaves neighbours correlated). Independent up to lags of 2²⁶ cells
/// (tests/surface/lattice_hash_test.cpp).
constexpr std::uint32_t cornerHash(std::uint32_t i, std::uint32_t j, LatticeSeeds seeds) {
  std::uint32_t h =
      ((i * latticeStrideX + seeds.x) ^ (j * latticeStrideY + seeds.y)) * latticeFirstFactor;
  h ^= h >> 15;
  h *= latticeSecondFactor;
  h ^= h >> 16;
  return h;
}

/// Low 32 bits of a cell's number, exact up to 2⁵³ cells.
constexpr std::uint32_t cellBits(double cell) {
  return static_cast<std::uint32_t>(static_cast<std::int64_t>(cell));
}

/// splitmix64 (Steele, Lea & Flood 2014, doi:10.1145/2714064.2660195): derives seeds from seeds.
constexpr std::uint64_t mixSeed(std::uint64_t state) {
  state += 0x9E3779B97F4A7C15u;
  state = (state ^ (state >> 30)) * 0xBF58476D1CE4E5B9u;
  state = (state ^ (state >> 27)) * 0x94D049BB133111EBu;
  return state ^ (state >> 31);
}

/// A number in [0, 1) from the top 53 bits of a mixed seed.
constexpr double unitFromSeed(std::uint64_t mixed) {
  return static_cast<double>(mixed >> 11) * 0x1.0p-53;
}

constexpr LatticeSeeds latticeSeeds(std::uint64_t seed) {
  const std::uint64_t mixed = mixSeed(seed);
  return {static_cast<std::uint32_t>(mixed >> 32), static_cast<std::uint32_t>(mixed)};
}

}  // namespace seaway
