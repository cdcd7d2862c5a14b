#include <gtest/gtest.h>

#include <cmath>

#include "surface/constants.h"
#include "surface/dispersion.h"
#include "tests/surface/disturbance/wake_support.h"

namespace seaway {
namespace {

using test::makeWindow;
using test::sail;
using test::straight;
using test::windowOf;

/// A straight course through still water until the wake is steady, in a window of 256² cells and
/// 128² modes or more; the vessel's bow points east.
struct SteadyWake {
  SteadyWake(const HullFootprint& hull, double speed, double size, double depth, int modes = 128)
      : window(makeWindow(
            [&] {
              WakeWindowSettings settings = windowOf(size, 2 * modes, modes);
              settings.depth = depth;
              settings.absorption = 40.0 * speed / size;
              return settings;
            }(),
            hull, size / speed / 400.0)) {
    const double dt = size / speed / 400.0;
    sail(window, dt, steps, straight(speed), 0.3 * size, 4);
    place = straight(speed)(steps * dt);
    centre = place.position - glm::dvec2(0.3 * size, 0.0);
  }

  /// Heights at points given from the vessel, astern and to port.
  std::vector<double> heights(const std::vector<glm::dvec2>& fromVessel) const {
    std::vector<glm::dvec2> points;
    for (const glm::dvec2 p : fromVessel) points.push_back(place.position + glm::dvec2(-p.x, p.y));
    std::vector<double> result;
    for (const SurfaceSample& s : test::samplesOf(test::stillState(window, centre), points)) {
      result.push_back(s.height);
    }
    return result;
  }

  static constexpr int steps = 1200;
  WakeWindow window;
  HullPlace place;
  glm::dvec2 centre{0.0};
};

/// Slope of the straight line through points of equal spacing.
double spacingOf(const std::vector<double>& places) {
  const double n = static_cast<double>(places.size());
  double sumX = 0, sumY = 0, sumXX = 0, sumXY = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const double x = static_cast<double>(i);
    sumX += x, sumY += places[i], sumXX += x * x, sumXY += x * places[i];
  }
  return (n * sumXY - sumX * sumY) / (n * sumXX - sumX * sumX);
}

TEST(WakePhysics, TransverseWavesAreAsLongAsTheShipsSpeedSays) {
  const HullFootprint hull = HullFootprint::wigley(12.0, 3.5, 0.8);
  for (const double speed : {3.0, 5.0, 8.0, 12.0}) {
    const double expected = 2.0 * pi * speed * speed / standardGravity;
    const SteadyWake wake(hull, speed, 20.0 * expected, deepWater);
    std::vector<glm::dvec2> track;
    for (int i = 0; i <= 4000; ++i) track.emplace_back(expected * (3.0 + 8.0 * i / 4000.0), 0.0);
    const std::vector<double> heights = wake.heights(track);
    std::vector<double> crossings;
    for (std::size_t i = 1; i < heights.size(); ++i) {
      if ((heights[i - 1] < 0.0) == (heights[i] < 0.0)) continue;
      const double part = heights[i - 1] / (heights[i - 1] - heights[i]);
      crossings.push_back(track[i - 1].x + part * (track[i].x - track[i - 1].x));
    }
    ASSERT_GE(crossings.size(), 12u) << speed;
    const double wavelength = 2.0 * spacingOf(crossings);
    RecordProperty("error_percent_at_" + std::to_string(static_cast<int>(speed)),
                   std::to_string(100.0 * (wavelength / expected - 1.0)));
    EXPECT_NEAR(wavelength / expected, 1.0, 0.005) << speed;
  }
}

}  // namespace
}  // namespace seaway
