#include "surface/field/perlin_spectrum.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <vector>

#include "surface/constants.h"
#include "surface/field/perlin_octave.h"

namespace seaway {
namespace {

TEST(PerlinSpectrum, HoldsTheWholeVariance) {
  double sum = 0.0;
  for (double q = 0.0; q < 5.0; q += 1e-3) sum += 1e-3 * perlinWaveNumberDensity(q);
  EXPECT_NEAR(sum, 1.0, 1e-4);  // the stated tail beyond q = 4
}

TEST(PerlinSpectrum, PeaksAtTheStatedWaveNumber) {
  double peak = 0.0;
  for (double q = 0.0; q < 2.0; q += 1e-3) {
    if (perlinWaveNumberDensity(q) > perlinWaveNumberDensity(peak)) peak = q;
  }
  EXPECT_NEAR(peak, perlinPeakCyclesPerCell, 0.006);  // the table's step
}

constexpr int cells = 48;   // across a square
constexpr int perCell = 4;  // samples: the octave has nothing to speak of beyond q = 2
constexpr int side = cells * perCell;
constexpr int squares = 24;

double taper(int i) { return std::pow(std::sin(pi * (i + 0.5) / side), 2.0); }

/// Tapered heights of one square, scaled so that its mean power is the octave's variance density.
std::vector<double> taperedSquare(const PerlinOctave& octave, int square) {
  const PerlinOctave::AtTime time = octave.at(0.0);
  std::vector<double> heights;
  double taper2 = 0.0;
  for (int j = 0; j < side; ++j) {
    for (int i = 0; i < side; ++i) {
      const glm::dvec2 point(square * 200.0 + static_cast<double>(i) / perCell,
                             static_cast<double>(j) / perCell);
      heights.push_back(taper(i) * taper(j) * octave.sample(point, time).height);
      taper2 += std::pow(taper(i) * taper(j), 2.0);
    }
  }
  for (double& height : heights) height /= std::sqrt(taper2) * perCell;
  return heights;
}

std::vector<std::complex<double>> phases(double cyclesPerCell) {
  std::vector<std::complex<double>> result;
  for (int i = 0; i < side; ++i)
    result.push_back(std::polar(1.0, 2.0 * pi * cyclesPerCell * i / perCell));
  return result;
}

double power(const std::vector<double>& heights, double q, double angle) {
  const auto alongX = phases(q * std::cos(angle)), alongY = phases(q * std::sin(angle));
  std::complex<double> sum = 0.0;
  for (int j = 0; j < side; ++j) {
    std::complex<double> row = 0.0;
    for (int i = 0; i < side; ++i)
      row += heights[static_cast<std::size_t>(j * side + i)] * alongX[static_cast<std::size_t>(i)];
    sum += row * alongY[static_cast<std::size_t>(j)];
  }
  return std::norm(sum);
}

TEST(PerlinSpectrum, AgreesWithAPeriodogramOfTheOctave) {
  const Octave unit = makePerlinOctave(1.0, 1.0, 0.0);
  const PerlinOctave octave(unit, 11, 0, {0.0, 0.0});
  std::vector<std::vector<double>> measured;
  for (int square = 0; square < squares; ++square)
    measured.push_back(taperedSquare(octave, square));
  for (const double q : {0.3, 0.6, 0.9, 1.2}) {
    double mean = 0.0;
    constexpr int angles = 16;
    for (const auto& heights : measured) {
      for (int a = 0; a < angles; ++a)
        mean += power(heights, q, (a + 0.37) * pi / angles) / (angles * squares);
    }
    // 16 × 24 exponential variates: relative standard error 5 %; 4 σ.
    EXPECT_NEAR(2.0 * pi * q * mean / perlinWaveNumberDensity(q), 1.0, 0.2) << q;
  }
}

}  // namespace
}  // namespace seaway
