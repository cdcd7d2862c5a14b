#include "surface/field/group_octave.h"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "surface/angles.h"
#include "surface/dispersion.h"

namespace seaway {
namespace {

/// Variance of the difference of two pairs of nibbles: four uniform values on 0 … 15.
constexpr double cornerVariance = 4.0 * (16.0 * 16.0 - 1.0) / 12.0;

/// One interpolation axis at fraction u of a cell: weights of the two corners; their slopes are
/// −rate·weight[1] and rate·weight[0].
struct Blend {
  explicit Blend(double u) {
    const double theta = 0.5 * pi * u * u * u * (u * (u * 6.0 - 15.0) + 10.0);
    weight = {std::cos(theta), std::sin(theta)};
    rate = 0.5 * pi * 30.0 * u * u * (1.0 - u) * (1.0 - u);
  }
  std::array<double, 2> weight;
  double rate;
};

/// Lattice noise with its derivatives along both axes, per cell.
struct Noise {
  double value = 0.0, along = 0.0, across = 0.0;

  void add(double corner, const Blend& x, const Blend& y, std::size_t i, std::size_t j) {
    const auto slope = [](const Blend& blend, std::size_t c) {
      return c == 0 ? -blend.rate * blend.weight[1] : blend.rate * blend.weight[0];
    };
    value += x.weight[i] * y.weight[j] * corner;
    along += slope(x, i) * y.weight[j] * corner;
    across += x.weight[i] * slope(y, j) * corner;
  }
};

double nibblePair(std::uint32_t hash, int byte) {
  return static_cast<double>(((hash >> (8 * byte)) & 15u) + ((hash >> (8 * byte + 4)) & 15u));
}

}  // namespace

GroupOctave::GroupOctave(const Octave& octave, std::uint64_t sceneSeed, std::uint64_t index,
                         glm::dvec2 current, double depth)
    : regular_(octave.kind == OctaveKind::regular),
      standardDeviation_(octave.standardDeviation),
      angularFrequency_(seaway::angularFrequency(octave.waveNumber, depth)),
      wavelength_(dominantWavelength(octave)) {
  const std::uint64_t seed = mixSeed(sceneSeed ^ mixSeed(index));
  const glm::dvec2 forward = unitVector(octave.toward);
  const double k = octave.waveNumber;
  direction_ = forward;
  bedDecay_ = std::exp(-2.0 * k * depth);
  orbitalVelocityPerHeight_ = forward * (angularFrequency_ / std::tanh(k * depth));
  turns_.gradient = forward * (k / (2.0 * pi));
  turns_.rate = -(angularFrequency_ + k * glm::dot(forward, current)) / (2.0 * pi);
  turns_.offset = regular_ ? octave.phase / (2.0 * pi) : unitFromSeed(mixSeed(seed + 1));
  seeds_ = latticeSeeds(seed + 2);
  if (regular_) return;
  const glm::dvec2 sideways(-forward.y, forward.x);
  along_.gradient = forward / octave.lengthAlong;
  along_.rate = -(groupSpeed(k, depth) + glm::dot(forward, current)) / octave.lengthAlong;
  along_.offset = 1024.0 * unitFromSeed(mixSeed(seed + 3));
  across_.gradient = sideways / octave.lengthAcross;
  across_.rate = -glm::dot(sideways, current) / octave.lengthAcross;
  across_.offset = 1024.0 * unitFromSeed(mixSeed(seed + 4));
}

GroupAtTime GroupOctave::at(double t) const noexcept {
  GroupAtTime result{along_, across_, turns_, seeds_, 0.0};
  result.amplitude = regular_ ? standardDeviation_ * std::sqrt(2.0)
                              : standardDeviation_ / std::sqrt(cornerVariance);
  result.turns = turnsAt(turns_, t);
  if (!regular_) {
    result.along = latticeAt(along_, t, result.seeds.x, latticeStrideX);
    result.across = latticeAt(across_, t, result.seeds.y, latticeStrideY);
  }
  return result;
}

OctaveSample GroupOctave::sample(glm::dvec2 point, const GroupAtTime& time) const noexcept {
  const double turns = time.turns.at(point);
  const double psi = 2.0 * pi * (turns - std::nearbyint(turns));
  const double cosine = std::cos(psi), sine = std::sin(psi);
  Noise a{1.0}, b;
  if (!regular_) {
    const double x = time.along.at(point), cellX = std::floor(x);
    const double y = time.across.at(point), cellY = std::floor(y);
    const Blend blendX(x - cellX), blendY(y - cellY);
    a.value = 0.0;
    for (std::uint32_t j = 0; j < 2; ++j) {
      for (std::uint32_t i = 0; i < 2; ++i) {
        const std::uint32_t hash = cornerHash(cellBits(cellX) + i, cellBits(cellY) + j, time.seeds);
        a.add(nibblePair(hash, 0) - nibblePair(hash, 1), blendX, blendY, i, j);
        b.add(nibblePair(hash, 2) - nibblePair(hash, 3), blendX, blendY, i, j);
      }
    }
  }
  // Derivatives of a height by phase (per turn) and by both lattice coordinates.
  const double byTurn = 2.0 * pi * (b.value * cosine - a.value * sine);
  const double byAlong = a.along * cosine + b.along * sine;
  const double byAcross = a.across * cosine + b.across * sine;
  OctaveSample result;
  result.height = time.amplitude * (a.value * cosine + b.value * sine);
  result.slope = time.amplitude * (byTurn * time.turns.gradient + byAlong * time.along.gradient +
                                   byAcross * time.across.gradient);
  result.verticalVelocity = time.amplitude * (byTurn * time.turns.rate + byAlong * time.along.rate +
                                              byAcross * time.across.rate);
  return result;
}

double GroupOctave::roundingBound(double reach) const noexcept {
  constexpr double epsilon = 0x1.0p-52;
  // Each coordinate carries three roundings of its own size. Per turn the height changes by at most
  // 2π·peak, per cell by (15/16)π·peak; the sums add some 40 roundings of the peak.
  const double units = 2.0 * pi * glm::length(turns_.gradient) +
                       3.0 * (glm::length(along_.gradient) + glm::length(across_.gradient));
  const double peak = standardDeviation_ * peakFactor();
  return epsilon * peak * (3.0 * (units * reach + 2.0 * pi + 6.0) + 40.0);
}

double GroupOctave::peakFactor() const {
  // Corner values reach 30; the weights of two corners add up to at most √2 along each axis; the
  // carrier turns A and B together by at most √2.
  return regular_ ? std::sqrt(2.0) : 30.0 * 2.0 * std::sqrt(2.0) / std::sqrt(cornerVariance);
}

}  // namespace seaway
