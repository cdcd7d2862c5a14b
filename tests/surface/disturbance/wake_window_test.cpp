#include "surface/disturbance/wake_window.h"

#include <gtest/gtest.h>

#include <cmath>

#include "surface/constants.h"
#include "surface/dispersion.h"
#include "surface/input_error.h"
#include "tests/surface/disturbance/wake_support.h"

namespace seaway {
namespace {

using test::makeWindow;
using test::sail;
using test::straight;
using test::windowOf;

const HullFootprint& launch() {
  static const HullFootprint hull = HullFootprint::wigley(12.0, 3.5, 0.8);
  return hull;
}

/// Nothing presses on the water.
HullPlace nowhere() { return {{0.0, 0.0}, 0.0, 0.0}; }

double largestDifference(const WakeWindow& a, const WakeWindow& b, double& largest) {
  const int half = a.settings().modes / 2;
  double difference = 0.0;
  largest = 0.0;
  for (int my = 1 - half; my < half; ++my) {
    for (int mx = 1 - half; mx < half; ++mx) {
      difference = std::max<double>(difference, std::abs(a.mode(mx, my) - b.mode(mx, my)));
      largest = std::max<double>(largest, std::abs(a.mode(mx, my)));
    }
  }
  return difference;
}

TEST(WakeWindow, FreeWavesTurnAtTheirFrequency) {
  for (const double depth : {deepWater, 3.0}) {
    WakeWindowSettings settings = windowOf(128.0, 128, 64);
    settings.depth = depth;
    WakeWindow window = makeWindow(settings, launch(), 0.1);
    sail(window, 0.1, 20, straight(5.0));
    const std::complex<double> before(window.mode(5, -3));
    for (int i = 0; i < 30; ++i) window.step(0.1, nowhere(), nowhere());
    const double omega = angularFrequency(2.0 * pi / 128.0 * std::hypot(5.0, 3.0), depth);
    const std::complex<double> expected = before * std::polar(1.0, -omega * 3.0);
    // Thirty multiplications in float, each some 1e-7; angles are tabled to 1e-5 of themselves.
    EXPECT_NEAR(std::abs(std::complex<double>(window.mode(5, -3)) - expected), 0.0,
                (3e-6 + 1e-5 * omega * 3.0) * std::abs(before));
  }
}

TEST(WakeWindow, AHullAtRestLiesInItsHollowAndMakesNoWaves) {
  const WakeWindowSettings settings = windowOf(128.0, 128, 64);
  WakeWindow window = makeWindow(settings, launch(), 0.1);
  const HullPlace place{{3.0, -2.0}, 0.7, 1.0};
  window.settle(place);
  const std::complex<float> before = window.mode(4, 2);
  for (int i = 0; i < 100; ++i) window.step(0.1, place, place);
  EXPECT_GT(std::abs(before), 0.0f);
  // A hundred roundings of 1e-7.
  EXPECT_NEAR(std::abs(window.mode(4, 2) - before), 0.0f, 1e-5f * std::abs(before));
  EXPECT_LE(window.waveEnergy(place), 1e-9 * window.energy() * 128.0 * 128.0);
}

TEST(WakeWindow, OneStepIsExactWhateverItsLength) {
  const WakeWindowSettings settings = windowOf(128.0, 128, 64);
  WakeWindow whole = makeWindow(settings, launch(), 4.0);
  WakeWindow parts = makeWindow(settings, launch(), 4.0 / 256);
  const auto course = straight(9.0, 0.4);
  whole.settle(course(0.0));
  parts.settle(course(0.0));
  whole.step(4.0, course(0.0), course(4.0));
  for (int i = 0; i < 256; ++i) {
    parts.step(4.0 / 256, course(i * 4.0 / 256), course((i + 1) * 4.0 / 256));
  }
  double largest = 0.0;
  const double difference = largestDifference(whole, parts, largest);
  // Angles of up to 20 rad, tabled to 1e-5 of themselves in the many steps.
  EXPECT_LE(difference, 2e-4 * largest);
}

TEST(WakeWindow, TheSameHeadingFromAnyQuarterGivesTheSameWakeTurned) {
  const WakeWindowSettings settings = windowOf(128.0, 128, 64);
  WakeWindow east = makeWindow(settings, launch(), 0.2),
             north = makeWindow(settings, launch(), 0.2);
  sail(east, 0.2, 50, straight(6.0, 0.0));
  sail(north, 0.2, 50, straight(6.0, pi / 2));
  double largest = 0.0, difference = 0.0;
  for (int m = -20; m <= 20; ++m) {
    for (int n = -20; n <= 20; ++n) {
      largest = std::max<double>(largest, std::abs(east.mode(m, n)));
      difference = std::max<double>(difference, std::abs(east.mode(m, n) - north.mode(-n, m)));
    }
  }
  EXPECT_LE(difference, 1e-4 * largest);  // cos(π/2) is 6e-17, phases differ by float roundings
}

TEST(WakeWindow, KeepsItsEnergyOverTenThousandSteps) {
  const WakeWindowSettings settings = windowOf(128.0, 256, 128);
  WakeWindow window = makeWindow(settings, launch(), 0.1);
  sail(window, 0.1, 100, straight(6.0));
  const double before = window.energy();
  for (int i = 0; i < 10000; ++i) window.step(0.1, nowhere(), nowhere());
  EXPECT_NEAR(window.energy() / before, 1.0, 5e-5);
}

TEST(WakeWindow, IsStableForStepsFromAMillisecondToTenSeconds) {
  const WakeWindowSettings settings = windowOf(128.0, 128, 64);
  WakeWindow window = makeWindow(settings, launch(), 0.1);
  double t = 0.0;
  const auto course = straight(7.0);
  window.settle(course(0.0));
  double largest = 0.0;
  for (int i = 0; i < 60; ++i) {
    const double dt = std::pow(10.0, -3.0 + 4.0 * ((7 * i) % 20) / 19.0);
    window.step(dt, course(t), course(t + dt));
    t += dt;
    window.absorb(course(t).position, dt);
    largest = std::max(largest, window.energy());
  }
  // A steady wake on this window has an energy of some 0.02 m²: nothing grows.
  EXPECT_LT(largest, 0.1);
  EXPECT_GT(window.energy(), 1e-4);
}

TEST(WakeWindow, TheBorderReturnsLessThanHalfAPercent) {
  // A ring of waves up to a quarter of the window's length leaves a window with a border, and one
  // of four times its size that they do not cross in the time.
  const double size = 256.0, dt = 0.2;
  WakeWindowSettings small = windowOf(size, 128, 128), large = windowOf(4 * size, 512, 512);
  small.band.longAll = large.band.longAll = 28.0;
  small.band.longNone = large.band.longNone = size / 4;
  const HullFootprint hull = HullFootprint::box(6.0, 6.0, 1.0);
  WakeWindow inner = makeWindow(small, hull, dt), truth = makeWindow(large, hull, dt);
  const HullPlace pressed{{0.0, 0.0}, 0.0, 1.0};
  inner.settle(pressed);
  truth.settle(pressed);  // and let go: a ring
  std::vector<glm::dvec2> within, ring;
  for (int i = 0; i < 14; ++i) within.emplace_back(5.0 * i, 1.0);
  for (int i = 0; i < 3; ++i) ring.emplace_back(60.0 + 5.0 * i, 1.0);
  double incident = 0.0, returned = 0.0;
  for (int i = 1; i <= 450; ++i) {
    inner.step(dt, nowhere(), nowhere());
    truth.step(dt, nowhere(), nowhere());
    if (i % 4 == 0) inner.absorb({0.0, 0.0}, 4 * dt);
    if (i % 10 != 0) continue;
    const DisturbanceState mine = test::stillState(inner, {0.0, 0.0});
    const DisturbanceState right = test::stillState(truth, {0.0, 0.0});
    for (const auto& sample : test::samplesOf(right, ring)) {
      if (i > 20) incident = std::max(incident, std::abs(sample.height));
    }
    const auto a = test::samplesOf(mine, within), b = test::samplesOf(right, within);
    for (std::size_t p = 0; p < within.size(); ++p) {
      returned = std::max(returned, std::abs(a[p].height - b[p].height));
    }
  }
  RecordProperty("returned_over_incident", std::to_string(returned / incident));
  EXPECT_GT(incident, 0.01);
  EXPECT_LE(returned, 0.005 * incident);  // in the middle, where what comes back meets
}

TEST(WakeWindow, ASplineOfItsCellsReadsTheFieldAndItsDerivatives) {
  const WakeWindowSettings settings = windowOf(64.0, 128, 64);
  WakeWindow window = makeWindow(settings, launch(), 0.1);
  sail(window, 0.1, 100, straight(4.0));
  const DisturbanceState state = test::stillState(window, {40.0, 0.0}, true);
  const std::vector<glm::dvec2> points{{20.3, 1.7}, {31.1, -4.4}, {44.25, 8.125}, {36.6, 0.9}};
  const auto samples = test::samplesOf(state, points, 0.0, {.orbitalVelocity = true});
  double largest = 0.0;
  std::vector<SurfaceSample> exact(points.size());
  const int half = settings.modes / 2;
  for (std::size_t p = 0; p < points.size(); ++p) {
    SurfaceSample& e = exact[p];
    e.orbitalVelocity = glm::dvec3(0.0);
    for (int my = 1 - half; my < half; ++my) {
      for (int mx = 1 - half; mx < half; ++mx) {
        const glm::dvec2 k = 2.0 * pi / 64.0 * glm::dvec2(mx, my);
        if (k == glm::dvec2(0.0)) continue;
        const double omega = angularFrequency(glm::length(k));
        const std::complex<double> i(0.0, 1.0);
        // A mode and its opposite's conjugate, as the equations read.
        const std::complex<double> z(window.mode(mx, my)), m(std::conj(window.mode(-mx, -my)));
        const std::complex<double> wave = std::polar(1.0, glm::dot(k, points[p]));
        const std::complex<double> height = 0.5 * (z + m) * wave;
        const std::complex<double> potential = standardGravity / (i * omega) * 0.5 * (z - m) * wave;
        e.height += height.real();
        e.slope += k * (i * height).real();
        e.verticalVelocity += (-i * omega * 0.5 * (z - m) * wave).real();
        e.orbitalVelocity += glm::dvec3(k * (i * potential).real(), 0.0);
      }
    }
    largest = std::max(largest, std::abs(e.height));
  }
  ASSERT_GT(largest, 0.05);
  for (std::size_t p = 0; p < points.size(); ++p) {
    // Splines with four cells to the shortest wave: measured 1.2e-3 of the largest height, 4e-3 m/s
    // of a velocity for each metre of it.
    EXPECT_NEAR(samples[p].height, exact[p].height, 2e-3 * largest) << p;
    EXPECT_NEAR(samples[p].height, exact[p].height, samples[p].bound) << p;
    EXPECT_NEAR(samples[p].slope.x, exact[p].slope.x, 2e-3 * largest) << p;
    EXPECT_NEAR(samples[p].slope.y, exact[p].slope.y, 2e-3 * largest) << p;
    EXPECT_NEAR(samples[p].verticalVelocity, exact[p].verticalVelocity, 4e-3 * largest) << p;
    EXPECT_NEAR(samples[p].orbitalVelocity.x, exact[p].orbitalVelocity.x, 6e-3 * largest) << p;
    EXPECT_NEAR(samples[p].orbitalVelocity.y, exact[p].orbitalVelocity.y, 6e-3 * largest) << p;
    EXPECT_EQ(samples[p].orbitalVelocity.z, samples[p].verticalVelocity) << p;
  }
}

TEST(WakeWindow, ACascadeOfTwoIsOneLargeFineWindow) {
  const double dt = 0.1, speed = 5.0;
  WakeWindowSettings one = windowOf(512.0, 512, 512);
  one.band.shortNone = 2.0, one.band.shortAll = 4.0;
  WakeWindowSettings fine = windowOf(256.0, 256, 256);
  fine.band = one.band;
  fine.band.longAll = 16.0, fine.band.longNone = 32.0;
  WakeWindowSettings coarse = windowOf(1024.0, 256, 128);
  coarse.band.shortNone = 16.0, coarse.band.shortAll = 32.0;
  WakeWindow whole = makeWindow(one, launch(), dt), near = makeWindow(fine, launch(), dt);
  WakeWindow far = makeWindow(coarse, launch(), 0.4);
  const int steps = 400;
  const auto course = straight(speed, 0.3);
  sail(whole, dt, steps, course, 0.0, 8);
  sail(near, dt, steps, course, 0.0, 8);
  sail(far, 0.4, steps / 4, course, 0.0, 2);
  const glm::dvec2 now = course(steps * dt).position;
  const glm::dvec2 ahead(std::cos(0.3), std::sin(0.3)), port(-ahead.y, ahead.x);
  std::vector<glm::dvec2> points;
  for (int i = 0; i < 40; ++i) {
    for (int j = -10; j <= 10; ++j)
      points.push_back(now - (8.0 + 1.7 * i) * ahead + 2.3 * j * port);
  }
  const auto truth = test::samplesOf(test::stillState(whole, now), points);
  const auto a = test::samplesOf(test::stillState(near, now), points);
  const auto b = test::samplesOf(test::stillState(far, now), points);
  double largest = 0.0, difference = 0.0;
  for (std::size_t p = 0; p < points.size(); ++p) {
    largest = std::max(largest, std::abs(truth[p].height));
    difference = std::max(difference, std::abs(a[p].height + b[p].height - truth[p].height));
  }
  RecordProperty("difference_over_largest", std::to_string(difference / largest));
  EXPECT_LE(difference, 0.01 * largest);
}

TEST(WakeWindowHard, RefusesSettingsThatCannotBe) {
  const auto refuses = [](auto change) {
    WakeWindowSettings settings;
    change(settings);
    EXPECT_THROW(check(settings), InputError);
  };
  refuses([](auto& s) { s.cells = 300; });
  refuses([](auto& s) { s.modes = 1024; });
  refuses([](auto& s) { s.cellSize = 0.0; });
  refuses([](auto& s) { s.depth = -1.0; });
  refuses([](auto& s) { s.band.shortNone = 0.5; });
  refuses([](auto& s) { s.band.longAll = s.band.longNone = 3.0; });
}

TEST(WakeWindowHard, AHullLargerThanTheWindowStaysFinite) {
  const WakeWindowSettings settings = windowOf(64.0, 64, 64);
  WakeWindow window = makeWindow(settings, HullFootprint::box(200.0, 30.0, 8.0), 0.1);
  sail(window, 0.1, 200, straight(8.0));
  EXPECT_TRUE(std::isfinite(window.energy()));
}

TEST(WakeWindowHard, AThousandKilometresAwayTheWakeIsTheSame) {
  const WakeWindowSettings settings = windowOf(128.0, 128, 64);
  WakeWindow here = makeWindow(settings, launch(), 0.1),
             there = makeWindow(settings, launch(), 0.1);
  const glm::dvec2 away(128.0 * 8000, -128.0 * 8000);
  sail(here, 0.1, 50, straight(6.0));
  sail(there, 0.1, 50, [&](double t) {
    HullPlace place = straight(6.0)(t);
    place.position += away;
    return place;
  });
  double largest = 0.0;
  // Places are reduced in double: 1e6 m keep 1e-10 m.
  const double difference = largestDifference(here, there, largest);
  EXPECT_LE(difference, 1e-5 * largest);
}

}  // namespace
}  // namespace seaway
