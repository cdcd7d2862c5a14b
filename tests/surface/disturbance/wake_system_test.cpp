#include "surface/disturbance/wake_system.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <thread>

#include "surface/constants.h"
#include "surface/input_error.h"

namespace seaway {
namespace {

HullFootprint launch() { return HullFootprint::wigley(12.0, 3.5, 0.8); }

/// Windows a quarter as large as the standard ones, to be quick.
WakeSystemSettings small() {
  WakeSystemSettings settings;
  WakeLevel fine, coarse;
  fine.step = 0.1;
  fine.window.cellSize = 0.5;
  fine.window.cells = 128;
  fine.window.modes = 64;
  fine.window.band = {2.0, 4.0, 8.0, 16.0};
  coarse.step = 0.2;
  coarse.window.cellSize = 2.0;
  coarse.window.cells = 128;
  coarse.window.modes = 64;
  coarse.window.band = {8.0, 16.0};
  settings.cascade = {fine, coarse};
  return settings;
}

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

WakePose sailing(double t, double speed = 4.0) { return {t, {speed * t, 0.0}, 0.0, 1.0}; }

/// Someone beside the course.
std::vector<WakeListener> beside(double x) { return {{{x, 20.0}, 5.0, 0}}; }

std::vector<glm::dvec2> astern(double x) {
  std::vector<glm::dvec2> points;
  for (int i = 0; i < 12; ++i) {
    for (int j = -3; j <= 3; ++j) points.emplace_back(x - 8.0 - 1.5 * i, 2.1 * j);
  }
  return points;
}

std::vector<SurfaceSample> sampled(const DisturbanceState& state, double t,
                                   const std::vector<glm::dvec2>& points,
                                   const SampleOptions& options = {}) {
  std::vector<SurfaceSample> samples(points.size());
  state.addTo(points, t, samples, options);
  return samples;
}

std::vector<double> heights(const DisturbanceState& state, double t,
                            const std::vector<glm::dvec2>& points) {
  std::vector<double> result;
  for (const auto& sample : sampled(state, t, points)) result.push_back(sample.height);
  return result;
}

double largestOf(const std::vector<double>& values) {
  double largest = 0.0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  return largest;
}

double largestDifference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

/// Sails from 0 to `end` in steps of `dt`, heard all the way.
std::uint32_t sail(WakeSystem& system, double end, double dt, double speed = 4.0) {
  const std::uint32_t vessel = system.addVessel(launch());
  for (int i = 0; i * dt <= end + 1e-9; ++i) {
    system.record(vessel, sailing(i * dt, speed));
    system.advance(i * dt, beside(speed * i * dt));
  }
  return vessel;
}

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

TEST(WakeSystemHard, APoseThatIsNoneLeavesTheWakeUnharmed) {
  WakeSystem spoilt(small()), clean(small());
  const std::uint32_t a = spoilt.addVessel(launch()), b = clean.addVessel(launch());
  for (int i = 0; i <= 40; ++i) {
    const double t = 0.1 * i;
    EXPECT_EQ(spoilt.record(a, sailing(t)), PoseAnswer::accepted);
    EXPECT_EQ(spoilt.record(a, {t + 0.05, {nan, 0.0}, 0.0, 1.0}), PoseAnswer::notFinite);
    EXPECT_EQ(spoilt.record(a, {t, {1.0, 2.0}, 0.0, 1.0}), PoseAnswer::notLater);
    clean.record(b, sailing(t));
    spoilt.advance(t, beside(4.0 * t));
    spoilt.advance(nan, beside(4.0 * t));
    clean.advance(t, beside(4.0 * t));
  }
  const auto points = astern(16.0);
  EXPECT_EQ(heights(*spoilt.latest(), 4.0, points), heights(*clean.latest(), 4.0, points));
  EXPECT_THROW(spoilt.record(77, sailing(1.0)), InputError);
}

/// Sails a course in steps of changing length and returns the largest |η| ever met near the vessel.
template <class Course>
double sailedAnyhow(WakeSystem& system, double end, Course course) {
  const std::uint32_t vessel = system.addVessel(launch());
  double t = 0.0, largest = 0.0;
  for (int i = 0; t < end; ++i) {
    const WakePose pose = course(t);
    system.record(vessel, pose);
    system.advance(t, std::vector<WakeListener>{{pose.position, 5.0, 0}});
    if (const auto state = system.latest()) {
      std::vector<glm::dvec2> points;
      for (int p = 0; p < 40; ++p) {
        points.push_back(pose.position + 3.0 * glm::dvec2(p % 8 - 4, p / 8 - 2));
      }
      largest = std::max(largest, largestOf(heights(*state, t, points)));
      EXPECT_TRUE(std::isfinite(largest)) << t;
    }
    t += std::pow(10.0, -3.0 + 3.0 * ((7 * i) % 10) / 9.0);  // 1 ms to 1 s
  }
  return largest;
}

TEST(WakeSystemHard, ReverseStopsAndStartsStayBounded) {
  WakeSystem system(small());
  const double largest = sailedAnyhow(system, 30.0, [](double t) {
    return WakePose{t, {20.0 * std::sin(0.3 * t), 0.0}, 0.0, 1.0};
  });
  EXPECT_GT(largest, 0.05);
  EXPECT_LT(largest, 2.0);  // a hull 0.8 m deep
}

TEST(WakeSystemHard, AJumpOfTenKilometresTakesTheVesselWithoutAWake) {
  WakeSystem system(small());
  const double largest = sailedAnyhow(system, 20.0, [](double t) {
    return WakePose{t, {4.0 * t + (t > 10.0 ? 1e4 : 0.0), 0.0}, 0.0, 1.0};
  });
  EXPECT_LT(largest, 2.0);
  EXPECT_EQ(system.running(), 1u);
}

TEST(WakeSystemHard, SixtyMetresASecondStayFinite) {
  WakeSystem system(small());
  const double largest = sailedAnyhow(system, 20.0, [](double t) {
    return WakePose{t, {60.0 * t, 0.0}, 0.0, 1.0};
  });
  EXPECT_LT(largest, 2.0);
}

TEST(WakeSystemHard, LeavingTheWaterAndReturningMakesRingsNoMore) {
  WakeSystem system(small());
  const double largest = sailedAnyhow(system, 30.0, [](double t) {
    return WakePose{t, {2.0 * t, 0.0}, 0.0, std::fmod(t, 6.0) < 3.0 ? 1.0 : 0.0};
  });
  EXPECT_LT(largest, 2.0);
}

TEST(WakeSystemHard, AHullLargerThanItsWindowsStaysFinite) {
  WakeSystem system(small());
  const std::uint32_t vessel = system.addVessel(HullFootprint::box(400.0, 60.0, 12.0));
  for (int i = 0; i <= 30; ++i) {
    system.record(vessel, sailing(0.1 * i));
    system.advance(0.1 * i, beside(0.4 * i));
  }
  EXPECT_TRUE(std::isfinite(largestOf(heights(*system.latest(), 3.0, astern(12.0)))));
}

TEST(WakeSystemHard, CrossingAndTouchingHullsAddUp) {
  WakeSystem both(small()), first(small()), second(small());
  const std::uint32_t a = both.addVessel(launch()), b = both.addVessel(launch());
  const std::uint32_t alone = first.addVessel(launch()), other = second.addVessel(launch());
  for (int i = 0; i <= 60; ++i) {
    const double t = 0.1 * i;
    const WakePose east = sailing(t), north{t, {12.0, 4.0 * t - 12.0}, pi / 2, 1.0};
    both.record(a, east);
    both.record(b, north);
    first.record(alone, east);
    second.record(other, north);
    for (WakeSystem* system : {&both, &first, &second}) system->advance(t, beside(12.0));
  }
  const auto points = astern(24.0);
  const auto sum = heights(*both.latest(), 6.0, points);
  const auto one = heights(*first.latest(), 6.0, points),
             two = heights(*second.latest(), 6.0, points);
  for (std::size_t i = 0; i < points.size(); ++i) EXPECT_NEAR(sum[i], one[i] + two[i], 1e-6);
}

TEST(WakeSystemHard, OfTwoHundredVesselsOnlyTheNearestRun) {
  WakeSystemSettings settings = small();
  settings.mostWakes = 3;
  WakeSystem system(settings);
  std::vector<std::uint32_t> fleet;
  for (int v = 0; v < 200; ++v) fleet.push_back(system.addVessel(launch()));
  for (int i = 0; i <= 20; ++i) {
    const double t = 0.1 * i;
    for (int v = 0; v < 200; ++v) {
      system.record(fleet[v], {t, {4.0 * t, 20.0 * v}, 0.0, 1.0});
    }
    system.advance(t, std::vector<WakeListener>{{{4.0 * t, 1000.0}, 5.0, 0}});
  }
  EXPECT_EQ(system.running(), 3u);
  ASSERT_EQ(system.latest()->wakes().size(), 3u);
  EXPECT_EQ(system.latest()->wakes()[1].vessel, fleet[50]);
}

TEST(WakeSystemHard, GoingBackInTimeRebuildsTheWakeOfThen) {
  WakeSystem system(small());
  sail(system, 6.0, 0.1);
  const auto points = astern(16.0);
  WakeSystem then(small());
  sail(then, 4.0, 0.1);
  system.advance(4.0, beside(16.0));
  EXPECT_EQ(heights(*system.latest(), 4.0, points), heights(*then.latest(), 4.0, points));
}

TEST(WakeSystemHard, AWholeDayLeavesNoMemoryBehind) {
  WakeSystemSettings settings;
  settings.cell = 2.0;  // one window of 64 cells: 400 000 steps would take a minute otherwise
  settings.window = 128.0;
  WakeSystem system(settings);
  const std::uint32_t vessel = system.addVessel(launch());
  std::size_t afterAnHour = 0, largest = 0;
  for (int t = 0; t <= 24 * 3600; ++t) {
    const WakePose pose = sailing(t, 4.0);
    system.record(vessel, pose);
    // Somebody is there for 10 s of every 5 minutes.
    const bool near = t % 300 < 10;
    system.advance(t, near ? std::vector<WakeListener>{{pose.position, 5.0, 0}}
                           : std::vector<WakeListener>{});
    largest = std::max(largest, system.memoryBytes());
    if (t == 3600) afterAnHour = largest;
  }
  EXPECT_GT(afterAnHour, 0u);
  EXPECT_EQ(largest, afterAnHour);
}

TEST(WakeSystemHard, ARemovedVesselsWavesLiveOn) {
  WakeSystem system(small());
  const std::uint32_t vessel = sail(system, 6.0, 0.1);
  system.removeVessel(vessel);
  for (int i = 61; i <= 80; ++i) system.advance(0.1 * i, beside(24.0));
  EXPECT_EQ(system.running(), 1u);
  EXPECT_THROW(system.record(vessel, sailing(9.0)), InputError);
  for (int i = 81; i <= 3000; i += 5) system.advance(0.1 * i, beside(24.0));
  EXPECT_EQ(system.running(), 0u);
}

}  // namespace
}  // namespace seaway
