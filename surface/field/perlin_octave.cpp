#include "surface/field/perlin_octave.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>

#include "surface/angles.h"

namespace seaway {
namespace {

/// Quintic fade 6u⁵ − 15u⁴ + 10u³ (Perlin 2002) and its derivative.
double fade(double u) { return u * u * u * (u * (u * 6.0 - 15.0) + 10.0); }
double fadeSlope(double u) { return 30.0 * u * u * (u - 1.0) * (u - 1.0); }

/// A corner's gradient: two bytes of its hash, centred on zero, −127.5 … 127.5.
glm::dvec2 gradientAt(std::uint32_t i, std::uint32_t j, LatticeSeeds seeds) {
  const std::uint32_t h = cornerHash(i, j, seeds);
  return {(h & 0xFFu) - 127.5, ((h >> 8) & 0xFFu) - 127.5};
}

constexpr double gradientVariance = (256.0 * 256.0 - 1.0) / 12.0;

/// One interpolation axis: weights of the two corners, their slopes, distances to the corners.
struct Axis {
  explicit Axis(double u)
      : weight{1.0 - fade(u), fade(u)},
        weightSlope{-fadeSlope(u), fadeSlope(u)},
        distance{u, u - 1.0} {}
  std::array<double, 2> weight, weightSlope, distance;
};

/// Root mean square of n₃. Σ_c w_c g_c·d_c with independent gradients of equal variance per
/// component has the mean square 2 σ_g² I₁ I₀ over the cell, I₀ = ∫Σw², I₁ = ∫Σw²d²; blending two
/// slices with weights of unit square sum leaves it as it is.
double noiseRms() {
  static const double value = [] {
    double i0 = 0.0, i1 = 0.0;
    constexpr int steps = 2000;  // midpoint rule on a smooth periodic integrand: error < 1e-12
    for (int n = 0; n < steps; ++n) {
      const Axis axis((n + 0.5) / steps);
      for (std::size_t c = 0; c < 2; ++c) {
        const double w2 = axis.weight[c] * axis.weight[c] / steps;
        i0 += w2;
        i1 += w2 * axis.distance[c] * axis.distance[c];
      }
    }
    return std::sqrt(2.0 * gradientVariance * i1 * i0);
  }();
  return value;
}

}  // namespace

PerlinOctave::PerlinOctave(const Octave& octave, std::uint64_t sceneSeed, std::uint64_t index,
                           glm::dvec2 current)
    : amplitude_(octave.standardDeviation / noiseRms()), wavelength_(dominantWavelength(octave)) {
  const std::uint64_t seed = mixSeed(sceneSeed ^ mixSeed(index));
  const glm::dvec2 axis = unitVector(2.0 * pi * unitFromSeed(mixSeed(seed + 1)));
  const glm::dvec2 velocity = octave.driftSpeed * unitVector(octave.toward) + current;
  const auto lattice = [&](glm::dvec2 direction, std::uint64_t offset) {
    const glm::dvec2 gradient = direction / octave.latticeSize;
    return LinearCoordinate{gradient, -glm::dot(gradient, velocity),
                            1024.0 * unitFromSeed(mixSeed(seed + offset))};
  };
  first_ = lattice(axis, 2);
  second_ = lattice({-axis.y, axis.x}, 3);
  slices_ = {{0.0, 0.0}, 1.0 / octave.boilTime, 1024.0 * unitFromSeed(mixSeed(seed + 4))};
  sliceSeed_ = mixSeed(seed + 5);
}

PerlinOctave::AtTime PerlinOctave::at(double t) const noexcept {
  AtTime result;
  const SplitOffset slice = offsetAt(slices_, t);
  const double angle = 0.5 * pi * fade(slice.rest);
  const double angleRate = 0.5 * pi * fadeSlope(slice.rest) * slices_.rate;
  result.weight = {std::cos(angle), std::sin(angle)};
  result.weightRate = {-result.weight[1] * angleRate, result.weight[0] * angleRate};
  result.amplitude = amplitude_;
  for (std::uint64_t i = 0; i < 2; ++i) {
    result.slice[i] = latticeSeeds(sliceSeed_ + static_cast<std::uint64_t>(slice.whole) + i);
    result.first = latticeAt(first_, t, result.slice[i].x, latticeStrideX);
    result.second = latticeAt(second_, t, result.slice[i].y, latticeStrideY);
  }
  return result;
}

OctaveSample PerlinOctave::sample(glm::dvec2 point, const AtTime& time) const noexcept {
  const double x = time.first.at(point), cellX = std::floor(x);
  const double y = time.second.at(point), cellY = std::floor(y);
  const Axis ax(x - cellX), ay(y - cellY);

  double value = 0.0, dx = 0.0, dy = 0.0, dt = 0.0;
  for (std::uint32_t j = 0; j < 2; ++j) {
    for (std::uint32_t i = 0; i < 2; ++i) {
      const std::uint32_t cornerX = cellBits(cellX) + i, cornerY = cellBits(cellY) + j;
      const glm::dvec2 before = gradientAt(cornerX, cornerY, time.slice[0]);
      const glm::dvec2 after = gradientAt(cornerX, cornerY, time.slice[1]);
      const glm::dvec2 gradient = time.weight[0] * before + time.weight[1] * after;
      const glm::dvec2 rate = time.weightRate[0] * before + time.weightRate[1] * after;
      const glm::dvec2 distance(ax.distance[i], ay.distance[j]);
      const double ramp = glm::dot(gradient, distance);
      const double wx = ax.weight[i], wy = ay.weight[j];
      value += wx * wy * ramp;
      dx += wy * (ax.weightSlope[i] * ramp + wx * gradient.x);
      dy += wx * (ay.weightSlope[j] * ramp + wy * gradient.y);
      dt += wx * wy * glm::dot(rate, distance);
    }
  }
  OctaveSample result;
  result.height = time.amplitude * value;
  result.slope = time.amplitude * (dx * time.first.gradient + dy * time.second.gradient);
  result.verticalVelocity = time.amplitude * (dt + dx * time.first.rate + dy * time.second.rate);
  return result;
}

double PerlinOctave::roundingBound(double reach) const noexcept {
  constexpr double epsilon = 0x1.0p-52;
  // Lattice coordinates carry three roundings of their own size. Per cell the noise changes by at
  // most Σ|w'|·|d|·|g| + Σw|g| ≤ (15/4 + 1)·peak. The sums add some 40 roundings of the peak.
  const double cells = 2.0 * glm::length(first_.gradient) * reach + 2.0;
  const double peak = amplitude_ * noiseRms() * peakFactor();
  return epsilon * peak * (3.0 * 4.75 * cells + 40.0);
}

double PerlinOctave::peakFactor() {
  // Σ_c w_c |d_c| is at most ½ along each axis (at the middle of the cell), a gradient's components
  // are at most 127.5, and the weights of two slices add up to at most √2.
  return std::sqrt(2.0) * 127.5 / noiseRms();
}

}  // namespace seaway
