#include "sim_bridge/cost/rivals/sine_sum.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "sim_bridge/cost/rivals/sine_kernel.h"
#include "surface/angles.h"
#include "surface/dispersion.h"

namespace seaway::rivals {

std::vector<double> bandEdges(const FrequencySpectrum& target, std::size_t count) {
  constexpr std::size_t steps = 20000;
  const double low = target.lowest(), step = (target.highest() - low) / steps;
  std::vector<double> share(steps + 1, 0.0);
  for (std::size_t i = 0; i < steps; ++i) {
    const double middle = low + (static_cast<double>(i) + 0.5) * step;
    share[i + 1] = share[i] + std::sqrt(target.at(middle));
  }
  std::vector<double> edges{low};
  std::size_t i = 0;
  for (std::size_t n = 1; n < count; ++n) {
    const double wanted = share.back() * static_cast<double>(n) / static_cast<double>(count);
    while (share[i + 1] < wanted) ++i;
    const double within = (wanted - share[i]) / (share[i + 1] - share[i]);
    edges.push_back(low + (static_cast<double>(i) + within) * step);
  }
  edges.push_back(target.highest());
  return edges;
}

std::vector<SineComponent> sineComponents(const FrequencySpectrum& target, std::size_t count) {
  const std::vector<double> edges = bandEdges(target, count);
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<SineComponent> components;
  constexpr int steps = 50;
  for (std::size_t n = 0; n < count; ++n) {
    const double width = edges[n + 1] - edges[n];
    double variance = 0.0;
    for (int i = 0; i < steps; ++i) {
      variance += target.at(edges[n] + (i + 0.5) / steps * width) * width / steps;
    }
    components.push_back({std::sqrt(2.0 * variance), edges[n] + 0.5 * width, unit(random) - 0.5,
                          2.0 * pi * unit(random)});
  }
  return components;
}

SineSum::SineSum(std::span<const SineComponent> components) {
  for (const SineComponent& c : components) {
    const double omega = 2.0 * pi * c.frequency;
    const glm::dvec2 k = waveNumber(omega) * unitVector(c.toward);
    prepared_.turnsPerMetreX.push_back(k.x / (2.0 * pi));
    prepared_.turnsPerMetreY.push_back(k.y / (2.0 * pi));
    prepared_.height.push_back(static_cast<float>(c.amplitude));
    prepared_.slopeX.push_back(static_cast<float>(-c.amplitude * k.x));
    prepared_.slopeY.push_back(static_cast<float>(-c.amplitude * k.y));
    prepared_.rate.push_back(static_cast<float>(c.amplitude * omega));
    turnsPerSecond_.push_back(-c.frequency);
    turnsAtStart_.push_back(c.phase / (2.0 * pi));
  }
  prepared_.turns.resize(components.size());
}

void SineSum::prepare(double t) {
  for (std::size_t i = 0; i < turnsPerSecond_.size(); ++i) {
    const double turns = turnsPerSecond_[i] * t + turnsAtStart_[i];
    prepared_.turns[i] = turns - std::round(turns);
  }
}

void SineSum::sample(std::span<const double> x, std::span<const double> y,
                     const FieldAtTime::Arrays& out) const {
  sumSines(prepared_, x, y, out);
}

std::size_t SineSum::memoryBytes() const {
  return turnsPerSecond_.size() * (5 * sizeof(double) + 4 * sizeof(float));
}

double sineSumHeight(std::span<const SineComponent> components, glm::dvec2 point, double t) {
  double sum = 0.0;
  for (const SineComponent& c : components) {
    const double omega = 2.0 * pi * c.frequency;
    const glm::dvec2 k = waveNumber(omega) * unitVector(c.toward);
    sum += c.amplitude * std::cos(glm::dot(k, point) - omega * t + c.phase);
  }
  return sum;
}

}  // namespace seaway::rivals
