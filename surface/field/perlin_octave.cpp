#include "surface/field/perlin_octave.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>

#include "surface/angles.h"
#include "surface/dispersion.h"
#include "surface/field/perlin_spectrum.h"

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
      : weight{1.0 - fade(u), fade(u)}, weightSlope{-fadeSlope(u), fadeSlope(u)},
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

std::uint32_t cellBits(double cell) {
  return static_cast<std::uint32_t>(static_cast<std::int64_t>(cell));
}

/// Beyond this many cells doubles no longer hold a fraction; the conversion to integers is exact
/// below it.
constexpr double largestCell = 9.0e15;

}  // namespace

PerlinOctave::PerlinOctave(const Octave& octave, std::uint64_t sceneSeed, std::uint64_t index,
                           glm::dvec2 current)
    : amplitude_(octave.standardDeviation / noiseRms()),
      cellsPerMetre_(1.0 / octave.latticeSize),
      slicesPerSecond_(1.0 / octave.boilTime),
      velocity_(octave.driftSpeed * unitVector(octave.toward) + current) {
  const std::uint64_t seed = mixSeed(sceneSeed ^ mixSeed(index));
  axis_ = unitVector(2.0 * pi * unitFromSeed(mixSeed(seed + 1)));
  offset_ = 1024.0 * glm::dvec2(unitFromSeed(mixSeed(seed + 2)), unitFromSeed(mixSeed(seed + 3)));
  timeOffset_ = 1024.0 * unitFromSeed(mixSeed(seed + 4));
  sliceSeed_ = mixSeed(seed + 5);
}

PerlinOctave::AtTime PerlinOctave::at(double t) const noexcept {
  AtTime result;
  const glm::dvec2 drift = velocity_ * t * cellsPerMetre_;
  result.latticeShift = offset_ - glm::dvec2(glm::dot(axis_, drift),
                                             axis_.x * drift.y - axis_.y * drift.x);
  const double slices = t * slicesPerSecond_ + timeOffset_;
  const double slice = std::floor(slices);
  const double angle = 0.5 * pi * fade(slices - slice);
  const double angleRate = 0.5 * pi * fadeSlope(slices - slice) * slicesPerSecond_;
  result.weight = {std::cos(angle), std::sin(angle)};
  result.weightRate = {-result.weight[1] * angleRate, result.weight[0] * angleRate};
  const auto number = static_cast<std::uint64_t>(
      static_cast<std::int64_t>(std::abs(slice) < largestCell ? slice : 0.0));
  result.slice[0] = latticeSeeds(sliceSeed_ + number);
  result.slice[1] = latticeSeeds(sliceSeed_ + number + 1);
  return result;
}

OctaveSample PerlinOctave::sample(glm::dvec2 point, const AtTime& time) const noexcept {
  const glm::dvec2 scaled = point * cellsPerMetre_;
  const double x = glm::dot(axis_, scaled) + time.latticeShift.x;
  const double y = axis_.x * scaled.y - axis_.y * scaled.x + time.latticeShift.y;
  const double cellX = std::floor(x), cellY = std::floor(y);
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
  result.height = amplitude_ * value;
  result.slope = amplitude_ * cellsPerMetre_ *
                 glm::dvec2(axis_.x * dx - axis_.y * dy, axis_.y * dx + axis_.x * dy);
  result.verticalVelocity = amplitude_ * dt - glm::dot(velocity_, result.slope);
  return result;
}

double PerlinOctave::roundingBound(double reach, double t) const noexcept {
  constexpr double epsilon = 0x1.0p-52;
  // Lattice coordinates carry three roundings of their own size, the slice number one. Per cell the
  // noise changes by at most Σ|w'|·|d|·|g| + Σw|g| ≤ (15/4 + 1)·peak, per slice by (15/16)π·peak.
  // The sums add some 40 roundings of the peak.
  const double cells = (reach + glm::length(velocity_) * std::abs(t)) * cellsPerMetre_ +
                       glm::length(offset_);
  const double slices = std::abs(t) * slicesPerSecond_ + timeOffset_;
  const double peak = amplitude_ * noiseRms() * peakFactor();
  return epsilon * peak * (3.0 * 4.75 * cells + 3.0 * slices + 40.0);
}

double PerlinOctave::peakFactor() {
  // Σ_c w_c |d_c| is at most ½ along each axis (at the middle of the cell), a gradient's components
  // are at most 127.5, and the weights of two slices add up to at most √2.
  return std::sqrt(2.0) * 127.5 / noiseRms();
}

Octave makePerlinOctave(double standardDeviation, double latticeSize, double toward,
                        double depth) {
  Octave octave;
  octave.standardDeviation = standardDeviation;
  octave.latticeSize = latticeSize;
  octave.toward = toward;
  const double k = 2.0 * pi * perlinPeakCyclesPerCell / latticeSize;
  octave.driftSpeed = phaseSpeed(k, depth);
  octave.boilTime = pi / angularFrequency(k, depth);
  return octave;
}

}  // namespace seaway
