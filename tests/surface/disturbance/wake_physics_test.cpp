#include <gtest/gtest.h>

#include <cmath>

#include "surface/constants.h"
#include "surface/dispersion.h"
#include "surface/disturbance/steady_wake.h"
#include "tests/surface/disturbance/wake_support.h"

namespace seaway {
namespace {

using test::makeWindow;
using test::sail;
using test::straight;
using test::windowOf;

double degrees(double angle) { return angle * 180.0 / pi; }

TEST(WakePhysics, TransverseWavesAreAsLongAsTheShipsSpeedSays) {
  const HullFootprint hull = HullFootprint::wigley(12.0, 3.5, 0.8);
  for (const double speed : {3.0, 5.0, 8.0, 12.0}) {
    const double expected = 2.0 * pi * speed * speed / standardGravity;
    const SteadyWake wake(hull, speed, 20.0 * expected, deepWater, 128);
    const double wavelength = transverseWavelength(wake, 3.0 * expected, 11.0 * expected);
    RecordProperty("error_percent_at_" + std::to_string(static_cast<int>(speed)),
                   std::to_string(100.0 * (wavelength / expected - 1.0)));
    EXPECT_NEAR(wavelength / expected, 1.0, 0.005) << speed;
  }
}

TEST(WakePhysics, TheCuspIsKelvinsWhereTheHullIsLongForItsSpeed) {
  for (const double froude : {0.3, 0.4, 0.5}) {
    const double speed = 5.0, length = std::pow(speed / froude, 2) / standardGravity;
    const double wavelength = 2.0 * pi * speed * speed / standardGravity;
    const HullFootprint hull = HullFootprint::wigley(length, 0.12 * length, 0.06 * length);
    const SteadyWake wake(hull, speed, 40.0 * wavelength, deepWater, 256);
    const double angle =
        degrees(ridgeAngleAtInfinity(ridgeOf(wake, 6.0 * wavelength, 22.0 * wavelength, 0.5)));
    RecordProperty("angle_at_" + std::to_string(froude), std::to_string(angle));
    EXPECT_NEAR(angle, degrees(std::asin(1.0 / 3.0)), 0.5) << froude;
  }
}

TEST(WakePhysics, TheWedgeOpensWithDepthAsHavelockSays) {
  EXPECT_NEAR(degrees(wedgeAngle(5.0, deepWater)), degrees(std::asin(1.0 / 3.0)),
              0.001);  // deep: Kelvin's
  const double speed = 5.0, wavelength = 2.0 * pi * speed * speed / standardGravity;
  for (const double froude : {0.7, 0.9}) {
    const double depth = std::pow(speed / froude, 2) / standardGravity;
    const HullFootprint hull = HullFootprint::wigley(0.5 * wavelength, 1.0, 0.4);
    const SteadyWake wake(hull, speed, 40.0 * wavelength, depth, 256);
    const double angle =
        degrees(ridgeAngleAtInfinity(ridgeOf(wake, 4.0 * wavelength, 12.0 * wavelength, 1.4)));
    RecordProperty("angle_at_" + std::to_string(froude), std::to_string(angle));
    // The Airy peak's law is extrapolated from 4 to 12 wavelengths.
    EXPECT_NEAR(angle, degrees(wedgeAngle(speed, depth)), 1.0) << froude;
  }
}

TEST(WakePhysics, BeyondTheCriticalSpeedTheWedgeIsMachs) {
  const double speed = 5.0, wavelength = 2.0 * pi * speed * speed / standardGravity;
  for (const double froude : {1.3, 1.6}) {
    const double depth = std::pow(speed / froude, 2) / standardGravity;
    EXPECT_NEAR(degrees(wedgeAngle(speed, depth)), degrees(std::asin(1.0 / froude)), 0.01);
    const HullFootprint hull = HullFootprint::wigley(2.0 * wavelength, 3.0, 0.5);
    const SteadyWake wake(hull, speed, 40.0 * wavelength, depth, 256);
    const double angle = degrees(frontAngle(wake, 4.0 * wavelength, 10.0 * wavelength, 1.4));
    RecordProperty("angle_at_" + std::to_string(froude), std::to_string(angle));
    EXPECT_NEAR(angle, degrees(wedgeAngle(speed, depth)), 1.5) << froude;
  }
}

TEST(WakePhysics, AThinShipsWavesAndResistanceAreMichells) {
  const double length = 12.0;
  const HullFootprint hull = HullFootprint::wigley(length, 3.5, 0.8).collapsedOntoCentreplane();
  for (const double speed : {6.0, 8.0}) {
    const double k0 = standardGravity / (speed * speed);
    SteadyWake wake(hull, speed, 256.0, deepWater, 256);
    // Waves shorter than the window carries are left out on both sides.
    const WavelengthBand band = wake.settings().band;
    const double steepest = std::acos(std::sqrt(k0 * band.shortNone / (2.0 * pi)));
    constexpr int directions = 4000;
    std::vector<std::complex<double>> amplitude;
    for (int i = 0; i <= directions; ++i) {
      const double theta = steepest * (2.0 * i / directions - 1.0);
      const double k = k0 / std::pow(std::cos(theta), 2);
      amplitude.push_back(
          band.weight(k) *
          hull.spectrum(k * glm::dvec2(std::cos(theta), std::sin(theta)), deepWater));
    }
    const auto overDirections = [&](auto integrand) {
      double sum = 0.0;  // Simpson
      for (int i = 0; i <= directions; ++i) {
        const double weight = i == 0 || i == directions ? 1.0 : i % 2 ? 4.0 : 2.0;
        sum += weight * integrand(steepest * (2.0 * i / directions - 1.0), amplitude[i]);
      }
      return sum * 2.0 * steepest / directions / 3.0;
    };
    // R = (ρU²k₀⁴/π) ∫₀^(π/2) sec⁵θ |Ĥ|² dθ, half of that over both sides.
    const double resistance = seaWaterDensity * speed * speed * std::pow(k0, 4) / (2.0 * pi) *
                              overDirections([](double theta, std::complex<double> h) {
                                return std::norm(h) / std::pow(std::cos(theta), 5);
                              });
    const double measured = wake.resistance();
    RecordProperty("resistance_ratio_at_" + std::to_string(speed),
                   std::to_string(measured / resistance));
    EXPECT_NEAR(measured / resistance, 1.0, 0.01) << speed;

    // η = Re (−i/π) ∫ κ² Ĥ e^(iκ·x) dθ far behind: the poles of the steady solution.
    std::vector<glm::dvec2> cut;
    for (int i = 0; i <= 60; ++i) cut.emplace_back(length * (1.5 + 5.0 * i / 60.0), length);
    const std::vector<double> heights = wake.heights(cut);
    double square = 0.0, error = 0.0;
    for (std::size_t p = 0; p < cut.size(); ++p) {
      const double height = overDirections([&](double theta, std::complex<double> h) {
                              const double k = k0 / std::pow(std::cos(theta), 2);
                              const double phase =
                                  k * (cut[p].y * std::sin(theta) - cut[p].x * std::cos(theta));
                              return k * k * (h * std::polar(1.0, phase)).imag();
                            }) /
                            pi;
      square += height * height;
      error += (heights[p] - height) * (heights[p] - height);
    }
    RecordProperty("cut_rms_error_at_" + std::to_string(speed),
                   std::to_string(std::sqrt(error / square)));
    EXPECT_LE(std::sqrt(error / square), 0.01) << speed;
  }
}

TEST(WakePhysics, ATurningVesselsWakeIsTheSumOfItsPulses) {
  // A round hull, so that a pulse is a function of distance and time alone:
  // η(r, τ) = −(1/2π) ∫ ω sin(ωτ) Ĥ(k) J₀(kr) k dk for a head that presses for an instant.
  std::vector<glm::dvec2> circle;
  for (int i = 0; i < 64; ++i)
    circle.emplace_back(2.0 * std::cos(pi * i / 32), 2.0 * std::sin(pi * i / 32));
  const HullFootprint hull({{0.0, circle}, {-0.8, circle}});
  const double speed = 5.0, rate = 0.2, radius = speed / rate, end = 12.0;
  const auto course = [&](double t) {
    return HullPlace{radius * glm::dvec2(std::sin(rate * t), 1.0 - std::cos(rate * t)), rate * t,
                     1.0};
  };
  WakeWindowSettings settings = windowOf(256.0, 256, 256);
  WakeWindow window = makeWindow(settings, hull, 0.1);
  sail(window, 0.1, 120, course);
  std::vector<glm::dvec2> points;
  for (int i = 0; i < 40; ++i) {
    const double t = end - 1.5 - 0.2 * i;
    points.push_back(course(t).position + (1.0 + 0.2 * (i % 7)) * 4.0 *
                                              glm::dvec2(std::sin(1.9 * i), std::cos(1.9 * i)));
  }
  const auto samples = test::samplesOf(test::stillState(window, course(end).position), points);
  const double largestK = 2.0 * pi / settings.band.shortNone;
  const int waves = 500, pulses = 480;
  std::vector<double> k(waves), omega(waves), factor(waves);
  for (int i = 0; i < waves; ++i) {
    k[i] = largestK * (i + 0.5) / waves;
    omega[i] = std::sqrt(standardGravity * k[i]);
    factor[i] = -omega[i] * settings.band.weight(k[i]) * k[i] *
                hull.spectrum({k[i], 0.0}, deepWater).real() * (largestK / waves) / (2.0 * pi);
  }
  double largest = 0.0, difference = 0.0;
  for (std::size_t p = 0; p < points.size(); ++p) {
    double height = 0.0;
    for (int j = 0; j < pulses; ++j) {
      const double t = end * (j + 0.5) / pulses, r = glm::length(points[p] - course(t).position);
      for (int i = 0; i < waves; ++i) {
        height += factor[i] * std::sin(omega[i] * (end - t)) * j0(k[i] * r) * (end / pulses);
      }
    }
    // The hollow it started from: −H where the hull lay, free since.
    const double r = glm::length(points[p] - course(0.0).position);
    for (int i = 0; i < waves; ++i)
      height += factor[i] / omega[i] * std::cos(omega[i] * end) * j0(k[i] * r);
    largest = std::max(largest, std::abs(height));
    difference = std::max(difference, std::abs(height - samples[p].height));
  }
  RecordProperty("difference_over_largest", std::to_string(difference / largest));
  ASSERT_GT(largest, 0.05);
  EXPECT_LE(difference, 0.02 * largest);
}

}  // namespace
}  // namespace seaway
