#include "sim_bridge/service/meter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <thread>

namespace seaway::bridge {
namespace {

TEST(Meter, CountsRequestsPointsRefusalsAndFrames) {
  Meters meters;
  Meter& meter = meters.of("cigi");
  EXPECT_EQ(&meter, &meters.of("cigi"));
  meter.answered(33, 40e-6);
  meter.answered(1000, 60e-6);
  meter.refused(Refusal::tooLarge);
  meter.frameSent(0.02);
  const auto all = meters.read();
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].first, "cigi");
  const MeterCounts& counts = all[0].second;
  EXPECT_EQ(counts.points, 1033u);
  EXPECT_EQ(counts.requests.total(), 2u);
  EXPECT_NEAR(counts.requests.sum, 100e-6, 2e-9);  // whole nanoseconds
  EXPECT_EQ(counts.frames.total(), 1u);
  EXPECT_EQ(counts.refusals[static_cast<std::size_t>(Refusal::tooLarge)], 1u);
}

TEST(Meter, QuantilesAreTheUpperEndOfTheirBucket) {
  LatencyMeter meter;
  for (int i = 1; i <= 1000; ++i) meter.add(1e-6 * i);
  const LatencyCounts counts = meter.read();
  EXPECT_DOUBLE_EQ(counts.quantile(0.5), 500e-6);
  EXPECT_DOUBLE_EQ(counts.quantile(0.99), 1000e-6);
  EXPECT_DOUBLE_EQ(counts.quantile(0.45), 500e-6);
  EXPECT_DOUBLE_EQ(counts.quantile(0.3), 315e-6);
  meter.add(0.5);
  EXPECT_DOUBLE_EQ(meter.read().since(counts).quantile(0.5), 0.5);
}

TEST(MeterHard, TimesOutOfAllBucketsAreCountedAllTheSame) {
  LatencyMeter meter;
  for (const double seconds : {0.0, -1.0, 1e-12, 1e9, std::nan("")}) meter.add(seconds);
  EXPECT_EQ(meter.read().total(), 5u);
  EXPECT_EQ(LatencyCounts{}.quantile(0.5), 0.0);
}

TEST(MeterHard, ManyThreadsLoseNothing) {
  Meters meters;
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([&] {
      Meter& meter = meters.of("grpc");
      for (int k = 0; k < 10000; ++k) meter.answered(3, 1e-6);
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(meters.read()[0].second.points, 120000u);
  EXPECT_EQ(meters.read()[0].second.requests.total(), 40000u);
}

}  // namespace
}  // namespace seaway::bridge
