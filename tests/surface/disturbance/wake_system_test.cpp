#include "surface/disturbance/wake_system.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <thread>

#include "surface/constants.h"
#include "surface/input_error.h"
#include "tests/surface/disturbance/wake_cases.h"

namespace seaway {
namespace {

using namespace test;

TEST(WakeSystem, HoldsNothingWhereNobodyIsNearOrNothingMoves) {
  WakeSystem system(small());
  const std::uint32_t vessel = system.addVessel(launch());
  for (int i = 0; i <= 50; ++i) {
    system.record(vessel, sailing(0.1 * i));
    system.advance(0.1 * i, {});
    EXPECT_EQ(system.latest(), nullptr);
  }
  EXPECT_EQ(system.running(), 0u);
  const std::vector<WakeListener> far{{{5000.0, 0.0}, 10.0, 0}};
  system.advance(5.0, far);
  EXPECT_EQ(system.running(), 0u);
  const std::vector<WakeListener> itself{{{20.0, 0.0}, 10.0, vessel}};
  system.advance(5.0, itself);
  EXPECT_EQ(system.running(), 0u);

  WakeSystem moored(small());
  const std::uint32_t buoy = moored.addVessel(launch());
  for (int i = 0; i <= 50; ++i) {
    moored.record(buoy, {0.1 * i, {0.0, 0.0}, 0.0, 1.0});
    moored.advance(0.1 * i, beside(0.0));
  }
  EXPECT_EQ(moored.running(), 0u);
  EXPECT_EQ(moored.latest(), nullptr);
}

TEST(WakeSystem, AWakeIsFeltByAllButItsVessel) {
  WakeSystem system(small());
  const std::uint32_t vessel = sail(system, 8.0, 0.1);
  const auto state = system.latest();
  ASSERT_NE(state, nullptr);
  const auto points = astern(32.0);
  EXPECT_GT(largestOf(heights(*state, 8.0, points)), 0.05);
  for (const auto& sample : sampled(*state, 8.0, points, {.excludeVessel = vessel})) {
    EXPECT_EQ(sample.height, 0.0);
    EXPECT_EQ(sample.status, SampleStatus::ok);
  }
  EXPECT_GE(state->heightBound(), largestOf(heights(*state, 8.03, points)));
}

TEST(WakeSystem, TheSameLogGivesTheSameBitsHoweverOftenItIsLookedAt) {
  WakeSystem often(small()), seldom(small());
  sail(often, 6.0, 0.05);
  const std::uint32_t vessel = seldom.addVessel(launch());
  for (int i = 0; i <= 120; ++i) {
    seldom.record(vessel, sailing(0.05 * i));
    if (i % 24 == 0) seldom.advance(0.05 * i, beside(0.2 * i));
  }
  const auto points = astern(24.0);
  EXPECT_EQ(heights(*often.latest(), 6.05, points), heights(*seldom.latest(), 6.05, points));
}

TEST(WakeSystem, AWakeRebuiltLateIsTheOneThatRanAllAlong) {
  WakeSystem early(small()), late(small());
  const double end = 60.0, speed = 5.0;
  sail(early, end, 0.1, speed);
  const std::uint32_t vessel = late.addVessel(launch());
  for (int i = 0; i <= 600; ++i) {
    late.record(vessel, sailing(0.1 * i, speed));
    late.advance(0.1 * i, {});
  }
  EXPECT_EQ(late.running(), 0u);
  late.advance(end, beside(speed * end));
  const auto points = astern(speed * end);
  const auto a = heights(*early.latest(), end, points), b = heights(*late.latest(), end, points);
  RecordProperty("difference_over_largest", std::to_string(largestDifference(a, b) / largestOf(a)));
  EXPECT_LE(largestDifference(a, b), 0.01 * largestOf(a));
}

TEST(WakeSystem, IsContinuousFromStateToState) {
  WakeSystem system(small());
  const std::uint32_t vessel = sail(system, 6.0, 0.1);
  const auto before = system.latest();
  system.record(vessel, sailing(6.1));
  system.advance(6.1, beside(24.0));
  const auto after = system.latest();
  ASSERT_NE(before, after);
  const auto points = astern(20.0);
  const auto a = heights(*before, before->end(), points);
  // Not all sheets take a step at once: those that did begin where they ended.
  EXPECT_LE(largestDifference(a, heights(*after, before->end(), points)), 1e-6);
}

TEST(WakeSystem, SaysWhenItIsAskedOutsideItsTimeOrItsWindows) {
  WakeSystem system(small());
  sail(system, 6.0, 0.1);
  const auto state = system.latest();
  EXPECT_LE(state->start(), 6.0);
  EXPECT_GE(state->end(), 6.0);
  const std::vector<glm::dvec2> near{{15.0, 1.0}}, border{{-60.0, 0.0}}, away{{900.0, 0.0}};
  EXPECT_EQ(sampled(*state, 6.0, near)[0].status, SampleStatus::ok);
  for (const double t : {3.0, 7.0}) {
    const SurfaceSample sample = sampled(*state, t, near)[0];
    EXPECT_TRUE(has(sample.status, SampleStatus::wakeOutOfTime)) << t;
    EXPECT_TRUE(std::isfinite(sample.height));
  }
  EXPECT_TRUE(has(sampled(*state, 6.0, border)[0].status, SampleStatus::wakePartial));
  const SurfaceSample nothing = sampled(*state, 6.0, away)[0];
  EXPECT_EQ(nothing.status, SampleStatus::ok);
  EXPECT_EQ(nothing.height, 0.0);
}

TEST(WakeSystem, GivesTheSameBitsForAnyBatch) {
  WakeSystem system(small());
  sail(system, 6.0, 0.1);
  const auto state = system.latest();
  std::vector<glm::dvec2> points;
  for (int i = 0; i < 1000; ++i) points.emplace_back(40.0 - 0.11 * i, 7.0 * std::sin(0.7 * i));
  const auto together = sampled(*state, 6.02, points);
  std::vector<float> x(1000), y(1000), rate(1000);
  std::vector<double> px, py;
  for (const glm::dvec2 p : points) px.push_back(p.x), py.push_back(p.y);
  std::vector<float> height(1000, 0.0f);
  state->addTo(px, py, 6.02, {height, x, y, rate}, {});
  for (std::size_t i = 0; i < points.size(); ++i) {
    const SurfaceSample alone = sampled(*state, 6.02, {points[i]})[0];
    EXPECT_EQ(alone.height, together[i].height);
    EXPECT_EQ(alone.slope, together[i].slope);
    EXPECT_EQ(alone.verticalVelocity, together[i].verticalVelocity);
    EXPECT_EQ(alone.status, together[i].status);
    EXPECT_EQ(static_cast<float>(alone.height), height[i]);
    EXPECT_EQ(static_cast<float>(alone.slope.y), y[i]);
  }
}

TEST(WakeSystem, IsDroppedWhenItsListenersHaveLeftOrItsWavesHave) {
  WakeSystem system(small());
  const std::uint32_t vessel = sail(system, 6.0, 0.1);
  EXPECT_EQ(system.running(), 1u);
  for (int i = 61; i <= 130; ++i) {
    system.record(vessel, sailing(0.1 * i));
    system.advance(0.1 * i, {});
  }
  EXPECT_EQ(system.running(), 0u);
  EXPECT_EQ(system.latest(), nullptr);
  // The vessel stops, its waves leave, and it lies still for good.
  for (int i = 131; i <= 4000; ++i) {
    system.record(vessel, {0.1 * i, {52.4, 0.0}, 0.0, 1.0});
    system.advance(0.1 * i, beside(52.0));
    if (i == 200) {
      EXPECT_EQ(system.running(), 1u);
    }
  }
  EXPECT_EQ(system.running(), 0u);
}

TEST(WakeSystem, ACurrentCarriesTheWakeAlong) {
  WakeSystemSettings drifting = small();
  drifting.current = {0.7, -0.3};
  WakeSystem still(small()), moving(drifting);
  const std::uint32_t a = still.addVessel(launch()), b = moving.addVessel(launch());
  for (int i = 0; i <= 60; ++i) {
    const double t = 0.1 * i;
    WakePose pose = sailing(t);
    still.record(a, pose);
    still.advance(t, beside(4.0 * t));
    pose.position += drifting.current * t;  // the same course through the water
    moving.record(b, pose);
    moving.advance(t, beside(4.0 * t));
  }
  auto points = astern(24.0);
  const auto here = sampled(*still.latest(), 6.0, points);
  for (glm::dvec2& point : points) point += drifting.current * 6.0;
  const auto there = sampled(*moving.latest(), 6.0, points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_NEAR(there[i].height, here[i].height, 1e-6);  // float, places in double
    EXPECT_NEAR(there[i].verticalVelocity,
                here[i].verticalVelocity - glm::dot(drifting.current, here[i].slope), 1e-5);
  }
}

TEST(WakeSystem, ReadersNeverSeeAHalfMadeState) {
  WakeSystem system(small());
  const std::uint32_t vessel = system.addVessel(launch());
  std::atomic<bool> done{false};
  std::atomic<int> bad{0};
  const auto read = [&] {
    const auto points = astern(10.0);
    while (!done) {
      const auto state = system.latest();
      if (!state) continue;
      const auto a = heights(*state, state->end(), points);
      const auto b = heights(*state, state->end(), points);
      if (a != b || !std::isfinite(largestOf(a))) ++bad;
    }
  };
  std::vector<std::thread> readers;
  for (int i = 0; i < 4; ++i) readers.emplace_back(read);
  for (int i = 0; i <= 60; ++i) {
    system.record(vessel, sailing(0.1 * i));
    system.advance(0.1 * i, beside(0.4 * i));
  }
  done = true;
  for (std::thread& reader : readers) reader.join();
  EXPECT_EQ(bad, 0);
  EXPECT_NE(system.latest(), nullptr);
}

TEST(WakeSystem, TellsTheLedgerWhatItDid) {
  EffectLedger ledger;
  WakeSystem system(small());
  const std::uint32_t vessel = system.addVessel(launch());
  system.record(vessel, sailing(0.0));
  system.record(vessel, sailing(1.0));
  system.advance(1.0, {}, &ledger);
  const auto wake = static_cast<std::size_t>(Effect::wake);
  EXPECT_EQ(ledger.report()[wake].state, EffectState::idle);
  EXPECT_EQ(ledger.report()[wake].memoryBytes, 0u);
  system.advance(1.0, beside(4.0), &ledger);
  EXPECT_EQ(ledger.report()[wake].state, EffectState::on);
  EXPECT_EQ(ledger.report()[wake].memoryBytes, system.memoryBytes());
  EXPECT_GT(ledger.report()[wake].costMicroseconds, 0.0);
  EXPECT_NE(ledger.report()[wake].reason.find("1 wakes"), std::string::npos);
  EffectSettings off{};
  off[wake] = EffectSetting::off;
  EffectLedger none(off);
  system.advance(1.0, beside(4.0), &none);
  EXPECT_EQ(system.running(), 0u);
  EXPECT_EQ(system.latest(), nullptr);
}

}  // namespace
}  // namespace seaway
