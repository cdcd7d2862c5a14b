#include "surface/fft/complex_fft.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

#include "surface/constants.h"
#include "surface/fft/aligned_vector.h"

namespace seaway {
namespace {

using Values = AlignedVector<std::complex<float>>;

Values randomValues(std::size_t size) {
  std::mt19937 random(static_cast<unsigned>(size));
  std::uniform_real_distribution<float> uniform(-1.0f, 1.0f);
  Values values(size);
  for (auto& value : values) value = {uniform(random), uniform(random)};
  return values;
}

std::complex<double> plainSum(const Values& bins, std::size_t n) {
  std::complex<double> sum = 0.0;
  for (std::size_t m = 0; m < bins.size(); ++m) {
    // m·n is reduced in integers: the angle keeps all its digits.
    const double turns =
        static_cast<double>(m * n % bins.size()) / static_cast<double>(bins.size());
    sum += std::complex<double>(bins[m]) * std::polar(1.0, 2.0 * pi * turns);
  }
  return sum;
}

/// Rounding of a float transform: some ε √(log₂ N) of the values' root mean square, which is below
/// their largest; 1e-6 is twice the largest error met.
constexpr double rounding = 1e-6;

TEST(ComplexFft, AgreesWithThePlainSum) {
  for (const std::size_t size : {1u, 2u, 8u, 12u, 256u, 512u, 1024u}) {
    const Values bins = randomValues(size);
    Values values = bins;
    ComplexFft(size).inverse(values.data());
    double largest = 0.0, error = 0.0;
    for (std::size_t n = 0; n < size; n += 1 + size / 37) {
      const std::complex<double> expected = plainSum(bins, n);
      largest = std::max(largest, std::abs(expected));
      error = std::max(error, std::abs(std::complex<double>(values[n]) - expected));
    }
    EXPECT_LE(error, rounding * largest) << size;
  }
}

TEST(ComplexFft, TransformsTogetherAreThoseOfEachAlone) {
  constexpr std::size_t size = 512, together = ComplexFft::together;
  const ComplexFft fft(size);
  const Values bins = randomValues(size * together);
  Values side = bins;
  fft.inverseTogether(side.data());
  for (std::size_t j = 0; j < together; ++j) {
    Values alone(size);
    for (std::size_t n = 0; n < size; ++n) alone[n] = bins[n * together + j];
    fft.inverse(alone.data());
    // Two plans may add in another order; values reach some √N.
    for (std::size_t n = 0; n < size; ++n) {
      EXPECT_NEAR(std::abs(side[n * together + j] - alone[n]), 0.0, rounding * 70.0);
    }
  }
}

TEST(ComplexFft, GivesTheSameBitsWhoeverPlansIt) {
  const Values bins = randomValues(512);
  Values first = bins, second = bins;
  ComplexFft(512).inverse(first.data());
  const ComplexFft other(256);
  ComplexFft(512).inverse(second.data());
  EXPECT_EQ(first, second);
}

TEST(ComplexFftHard, RefusesLengthsThatCannotBe) {
  EXPECT_THROW(ComplexFft(0), std::runtime_error);
}

}  // namespace
}  // namespace seaway
