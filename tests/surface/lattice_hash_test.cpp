#include "surface/field/lattice_hash.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace seaway {
namespace {

constexpr LatticeSeeds seeds = latticeSeeds(7);

/// χ² of the joint distribution of the top four bits of a hash byte at two corners.
double neighbourChiSquare(int di, int dj, int shift) {
  std::array<int, 256> counts{};
  constexpr int side = 512;
  for (int j = 0; j < side; ++j) {
    for (int i = 0; i < side; ++i) {
      const std::uint32_t a = cornerHash(i, j, seeds), b = cornerHash(i + di, j + dj, seeds);
      ++counts[((a >> shift) & 15u) * 16 + ((b >> shift) & 15u)];
    }
  }
  const double expected = side * side / 256.0;
  double sum = 0.0;
  for (const int count : counts) sum += (count - expected) * (count - expected) / expected;
  return sum;
}

TEST(LatticeHash, NeighbouringCornersAreIndependent) {
  // χ² with 255 degrees of freedom has mean 255 and standard deviation 22.6; 48 tests at 4.5 σ
  // (357) fail by chance once in 3000 hashes.
  for (const auto& [di, dj] :
       {std::pair{1, 0}, {0, 1}, {1, 1}, {1, -1}, {2, 0}, {0, 2}, {3, 1}, {16, 0}}) {
    for (const int shift : {4, 12, 20})
      EXPECT_LT(neighbourChiSquare(di, dj, shift), 357.0) << di << ' ' << dj << ' ' << shift;
  }
}

/// Correlation of a hash byte with itself at a lag along x.
double correlation(std::uint32_t lag, int shift) {
  double sum = 0.0;
  constexpr int samples = 20000;
  for (std::uint32_t n = 0; n < samples; ++n) {
    const double a = ((cornerHash(n, n / 100, seeds) >> shift) & 255u) - 127.5;
    const double b = ((cornerHash(n + lag, n / 100, seeds) >> shift) & 255u) - 127.5;
    sum += a * b;
  }
  return sum / samples / ((256.0 * 256.0 - 1.0) / 12.0);
}

TEST(LatticeHashHard, LongPowerOfTwoLagsAreUncorrelated) {
  // 2²⁶ cells of 0.1 m are 6700 km, more than the geodesy serves.
  for (int power = 8; power <= 26; ++power) {
    for (const int shift : {0, 8, 16}) {
      EXPECT_LT(std::abs(correlation(1u << power, shift)), 5.0 / std::sqrt(20000.0))
          << power;  // 5 σ
    }
  }
}

TEST(LatticeHash, BytesAreUniform) {
  std::vector<int> counts(256);
  for (std::uint32_t j = 0; j < 1024; ++j)
    for (std::uint32_t i = 0; i < 1024; ++i) ++counts[cornerHash(i, j, seeds) & 255u];
  double sum = 0.0;
  for (const int count : counts) sum += (count - 4096.0) * (count - 4096.0) / 4096.0;
  EXPECT_LT(sum, 357.0);
}

TEST(LatticeHash, IsPinned) {
  // Fields are reproducible across releases: a change of these numbers changes every user's sea.
  EXPECT_EQ(cornerHash(0, 0, {1, 2}), 2852385223u);
  EXPECT_EQ(cornerHash(12345u, static_cast<std::uint32_t>(-678), {1, 2}), 3595836815u);
  EXPECT_EQ(mixSeed(0), 0xE220A8397B1DCDAFu);  // splitmix64's published first output
}

}  // namespace
}  // namespace seaway
