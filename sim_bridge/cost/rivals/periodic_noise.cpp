#include "sim_bridge/cost/rivals/periodic_noise.h"

#include <cmath>

#include "surface/constants.h"
#include "surface/field/lattice_hash.h"

namespace seaway::rivals {
namespace {

double fade(double u) { return u * u * u * (u * (u * 6.0 - 15.0) + 10.0); }
double fadeSlope(double u) { return 30.0 * u * u * (u - 1.0) * (u - 1.0); }

/// Root mean square of the noise over a cell: √(2 σ_g² I₁ I₀), as in PerlinOctave.
double noiseRms() {
  static const double value = [] {
    double i0 = 0.0, i1 = 0.0;
    constexpr int steps = 2000;
    for (int n = 0; n < steps; ++n) {
      const double u = (n + 0.5) / steps, w = fade(u);
      i0 += ((1.0 - w) * (1.0 - w) + w * w) / steps;
      i1 += ((1.0 - w) * (1.0 - w) * u * u + w * w * (1.0 - u) * (1.0 - u)) / steps;
    }
    return std::sqrt(2.0 * (256.0 * 256.0 - 1.0) / 12.0 * i1 * i0);
  }();
  return value;
}

/// Position within a cell on one axis.
struct Axis {
  explicit Axis(double u)
      : weight{static_cast<float>(1.0 - fade(u)), static_cast<float>(fade(u))},
        slope(static_cast<float>(fadeSlope(u))),
        distance{static_cast<float>(u), static_cast<float>(u - 1.0)} {}
  float weight[2];
  float slope;
  float distance[2];
};

}  // namespace

PeriodicNoise::PeriodicNoise(std::uint64_t seed, std::uint32_t cells, double boilTime, double t)
    : cells_(cells), gradients_(std::size_t{cells} * cells) {
  const double slice = std::floor(t / boilTime), rest = t / boilTime - slice;
  const double angle = 0.5 * pi * fade(rest), angleRate = 0.5 * pi * fadeSlope(rest) / boilTime;
  const auto number = static_cast<std::uint64_t>(static_cast<std::int64_t>(slice));
  const LatticeSeeds before = latticeSeeds(seed + number), after = latticeSeeds(seed + number + 1);
  const float scale = static_cast<float>(1.0 / noiseRms());
  const float a = scale * static_cast<float>(std::cos(angle));
  const float b = scale * static_cast<float>(std::sin(angle));
  const float rate = static_cast<float>(angleRate);
  const auto byte = [](std::uint32_t h) { return static_cast<float>(h & 0xFFu) - 127.5f; };
  for (std::uint32_t n = 0; n < cells * cells; ++n) {
    const std::uint32_t h = cornerHash(n % cells, n / cells, before);
    const std::uint32_t k = cornerHash(n % cells, n / cells, after);
    gradients_[n] = {a * byte(h) + b * byte(k), a * byte(h >> 8) + b * byte(k >> 8),
                     rate * (a * byte(k) - b * byte(h)),
                     rate * (a * byte(k >> 8) - b * byte(h >> 8))};
  }
}

double PeriodicNoise::at(double u, double v) const {
  const double cellU = std::floor(u), cellV = std::floor(v);
  const std::uint32_t i = cellBits(cellU), j = cellBits(cellV);
  double value = 0.0;
  for (std::uint32_t b = 0; b < 2; ++b) {
    for (std::uint32_t a = 0; a < 2; ++a) {
      const Gradient& g = corner(i + a, j + b);
      const double du = u - cellU - a, dv = v - cellV - b;
      const double weight = fade(1.0 - std::abs(du)) * fade(1.0 - std::abs(dv));
      value += weight * (g.x * du + g.y * dv);
    }
  }
  return value;
}

void PeriodicNoise::addTo(std::vector<Texel>& out, std::uint32_t texels, double amplitude,
                          double perMetre) const {
  const std::uint32_t perCell = texels / cells_;
  std::vector<Axis> axes;
  for (std::uint32_t n = 0; n < perCell; ++n) axes.emplace_back((n + 0.5) / perCell);
  const float height = static_cast<float>(amplitude);
  const float slope = static_cast<float>(amplitude * perMetre);
  for (std::uint32_t n = 0; n < texels * texels; ++n) {
    const std::uint32_t column = n % texels, row = n / texels;
    const Axis& u = axes[column % perCell];
    const Axis& v = axes[row % perCell];
    float value = 0.0f, dx = 0.0f, dy = 0.0f, dt = 0.0f;
    for (std::uint32_t b = 0; b < 2; ++b) {
      for (std::uint32_t a = 0; a < 2; ++a) {
        const Gradient& g = corner(column / perCell + a, row / perCell + b);
        const float ramp = g.x * u.distance[a] + g.y * v.distance[b];
        const float wu = u.weight[a], wv = v.weight[b];
        value += wu * wv * ramp;
        dx += wv * ((a ? u.slope : -u.slope) * ramp + wu * g.x);
        dy += wu * ((b ? v.slope : -v.slope) * ramp + wv * g.y);
        dt += wu * wv * (g.rateX * u.distance[a] + g.rateY * v.distance[b]);
      }
    }
    out[n].height += height * value;
    out[n].slopeX += slope * dx;
    out[n].slopeY += slope * dy;
    out[n].rate += height * dt;
  }
}

}  // namespace seaway::rivals
