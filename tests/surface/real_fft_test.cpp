#include "surface/fft/real_fft.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <thread>
#include <vector>

#include "surface/constants.h"

namespace seaway {
namespace {

using Bins = std::vector<std::complex<double>>;

std::vector<double> randomValues(std::size_t size) {
  std::mt19937_64 random(size);
  std::vector<double> values(size);
  for (double& value : values) value = static_cast<double>(random() >> 11) * 0x1p-53 - 0.5;
  return values;
}

Bins transformed(const std::vector<double>& values) {
  const RealFft fft(values.size());
  Bins bins(fft.bins());
  fft.forward(values, bins);
  return bins;
}

std::complex<double> plainSum(const std::vector<double>& values, std::size_t m) {
  std::complex<double> sum = 0.0;
  for (std::size_t n = 0; n < values.size(); ++n) {
    // m·n is reduced in integers: the angle keeps all its digits.
    const auto turns =
        static_cast<double>(m * n % values.size()) / static_cast<double>(values.size());
    sum += values[n] * std::polar(1.0, -2.0 * pi * turns);
  }
  return sum;
}

TEST(RealFft, AgreesWithThePlainSumAtAnyLength) {
  for (const std::size_t size : {1u, 2u, 7u, 30u, 97u, 512u, 4096u}) {
    const std::vector<double> values = randomValues(size);
    const Bins bins = transformed(values);
    ASSERT_EQ(bins.size(), size / 2 + 1);
    double largest = 0.0, error = 0.0;
    for (std::size_t m = 0; m < bins.size(); ++m) {
      const std::complex<double> expected = plainSum(values, m);
      largest = std::max(largest, std::abs(expected));
      error = std::max(error, std::abs(bins[m] - expected));
    }
    EXPECT_LE(error, 1e-14 * largest) << size;  // rounding of some 64 additions that add at random
  }
}

TEST(RealFft, KeepsWhatItReads) {
  const std::vector<double> values = randomValues(60);
  std::vector<double> same = values;
  transformed(same);
  EXPECT_EQ(same, values);
}

TEST(RealFftHard, AnObjectServesManyThreadsWhileOthersPlan) {
  const std::vector<double> values = randomValues(360);
  const Bins expected = transformed(values);
  const RealFft shared(values.size());
  std::vector<Bins> results(8, Bins(shared.bins()));
  std::vector<std::thread> threads;
  for (Bins& result : results) {
    threads.emplace_back([&] {
      for (std::size_t i = 0; i < 50; ++i) {
        const RealFft other(64 + i);
        shared.forward(values, result);
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const Bins& result : results) EXPECT_EQ(result, expected);
}

}  // namespace
}  // namespace seaway
