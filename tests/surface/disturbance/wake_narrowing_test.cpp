#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>

#include "surface/disturbance/steady_wake.h"

// Fast vessels' wakes look narrower than Kelvin's: a hull makes waves about as long as itself best,
// and those of them that keep up with it go out at ever smaller angles (Rabaud & Moisy 2013,
// doi:10.1103/PhysRevLett.110.214503): tan α = √(2π Fr² − 1)/(4π Fr² − 1), about 1/Fr.
namespace seaway {
namespace {

constexpr double length = 4.0;  // m
constexpr double degree = std::numbers::pi / 180.0;

/// Angle of the highest waves 12 to 26 hull lengths astern, rad.
double angleOfHighest(double froude) {
  const double speed = froude * std::sqrt(9.80665 * length);
  const SteadyWake wake(HullFootprint::wigley(length, 0.1 * length, 0.0625 * length), speed,
                        48.0 * length, std::numeric_limits<double>::infinity(), 256);
  double sum = 0.0;
  const auto ridge = ridgeOf(wake, 12.0 * length, 26.0 * length, 0.45);
  for (const RidgePoint& point : ridge) sum += std::atan(point.aside / point.astern);
  return sum / static_cast<double>(ridge.size());
}

TEST(WakePhysics, HighestWavesNarrowAsOneOverFroudesNumber) {
  // A slow hull's are at Kelvin's cusp, but for the Airy function's width so near the hull.
  EXPECT_NEAR(angleOfHighest(0.4), 19.47 * degree, 2.0 * degree);
  for (const double froude : {0.8, 1.0, 1.25, 1.5}) {
    const double square = froude * froude, angle = angleOfHighest(froude);
    const double theory = std::atan(std::sqrt(2.0 * std::numbers::pi * square - 1.0) /
                                    (4.0 * std::numbers::pi * square - 1.0));
    std::printf("Fr %.2f: %.2f deg, theory %.2f deg\n", froude, angle / degree, theory / degree);
    // The theory takes waves as long as the hull for the highest; a Wigley hull's bow and stern
    // interfere besides.
    EXPECT_NEAR(angle, theory, 0.15 * theory) << froude;
    EXPECT_NEAR(angle * froude, 10.2 * degree, 0.08 * 10.2 * degree) << froude;
  }
}

}  // namespace
}  // namespace seaway
