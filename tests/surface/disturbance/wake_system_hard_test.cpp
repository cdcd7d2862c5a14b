#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "surface/constants.h"
#include "surface/disturbance/wake_system.h"
#include "surface/input_error.h"
#include "tests/surface/disturbance/wake_cases.h"

namespace seaway {
namespace {

using namespace test;

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

TEST(WakeSystemHard, WhoHoversBetweenTwoWakesDoesNotMakeThemFlicker) {
  WakeSystemSettings settings = small();
  settings.mostWakes = 1;
  WakeSystem system(settings);
  const std::uint32_t one = system.addVessel(launch()), other = system.addVessel(launch());
  const glm::dvec2 apart(0.0, 40.0);
  int changes = 0;
  bool before = false;
  for (int i = 0; i <= 80; ++i) {
    const double t = 0.1 * i;
    const WakePose pose = sailing(t);
    WakePose abeam = pose;
    abeam.position += apart;
    system.record(one, pose);
    system.record(other, abeam);
    // Now nearer to the one, now to the other.
    const glm::dvec2 hovering = pose.position + 0.5 * apart + glm::dvec2(0.0, i % 2 ? 1.0 : -1.0);
    const std::vector<WakeListener> between{{hovering, 5.0, 0}};
    system.advance(t, between);
    ASSERT_EQ(system.running(), i < 2 ? system.running() : 1u);
    if (i < 30) continue;  // waves have risen
    const std::vector<glm::dvec2> behind{pose.position - glm::dvec2(8.0, 0.0)};
    const auto state = system.latest();
    ASSERT_NE(state, nullptr);
    const bool oneRuns = sampled(*state, t, behind, {.excludeVessel = other})[0].height != 0.0;
    changes += i > 30 && oneRuns != before;
    before = oneRuns;
  }
  EXPECT_EQ(changes, 0);
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
    system.advance(
        t, near ? std::vector<WakeListener>{{pose.position, 5.0, 0}} : std::vector<WakeListener>{});
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
