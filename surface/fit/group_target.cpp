#include "surface/fit/group_target.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "surface/dispersion.h"

namespace seaway::fit {
namespace {

/// Where a frequency lies among the bins: between bin i and i + 1.
struct Between {
  std::size_t i = 0;
  double fraction = 0.0;

  template <typename Value>
  double of(const Value& value) const {
    if (fraction == 0.0) return value(i);
    if (fraction == 1.0) return value(i + 1);
    return (1.0 - fraction) * value(i) + fraction * value(i + 1);
  }
};

Between between(const std::vector<double>& bins, double f) {
  const auto above = std::upper_bound(bins.begin() + 1, bins.end() - 1, f);
  const auto i = static_cast<std::size_t>(above - bins.begin()) - 1;
  return {i, std::clamp((f - bins[i]) / (bins[i + 1] - bins[i]), 0.0, 1.0)};
}

std::vector<double> uniformFrequencies(const FrequencySpectrum& target, std::size_t points) {
  std::vector<double> result(points);
  const double band = target.highest() - target.lowest();
  for (std::size_t i = 0; i < points; ++i) {
    result[i] = target.lowest() + band * static_cast<double>(i) / static_cast<double>(points - 1);
  }
  result.back() = target.highest();
  return result;
}

/// Equal shares of a measure that is half ln f, half √S.
std::vector<double> crowdedFrequencies(const FrequencySpectrum& target, std::size_t points) {
  const std::vector<double> fine = uniformFrequencies(target, 4096);
  std::vector<double> root(fine.size());
  double total = 0.0;
  for (std::size_t i = 0; i < fine.size(); ++i) total += root[i] = std::sqrt(target.at(fine[i]));
  std::vector<double> cumulative(fine.size(), 0.0);
  for (std::size_t i = 1; i < fine.size(); ++i) {
    cumulative[i] = cumulative[i - 1] +
                    0.5 * std::log(fine[i] / fine[i - 1]) / std::log(fine.back() / fine.front()) +
                    0.25 * (root[i] + root[i - 1]) / total;
  }
  std::vector<double> result(points);
  for (std::size_t p = 0; p < points; ++p) {
    const double share =
        cumulative.back() * static_cast<double>(p) / static_cast<double>(points - 1);
    const Between at = between(cumulative, share);
    result[p] = at.of([&](std::size_t i) { return fine[i]; });
  }
  result.back() = target.highest();
  return result;
}

std::vector<double> trapezoidWeights(const std::vector<double>& frequency) {
  std::vector<double> weight(frequency.size());
  for (std::size_t i = 0; i < frequency.size(); ++i) {
    const double below = frequency[i > 0 ? i - 1 : i];
    const double above = frequency[std::min(i + 1, frequency.size() - 1)];
    weight[i] = 0.5 * (above - below);
  }
  return weight;
}

void sampleMoments(const DirectionalSpectrum& target, GroupTarget& result) {
  bool first = false, second = false;
  for (const DirectionalMoments& m : target.moments) {
    first = first || m.hasFirst();
    second = second || m.hasSecond();
  }
  const auto sample = [&](double DirectionalMoments::*moment, std::vector<double>& into) {
    for (const double f : result.frequency) {
      into.push_back(between(target.energy.frequency, f).of([&](std::size_t i) {
        return target.energy.density[i] / result.variance * (target.moments[i].*moment);
      }));
    }
  };
  if (first) {
    sample(&DirectionalMoments::a1, result.east);
    sample(&DirectionalMoments::b1, result.north);
  }
  if (first && second) {
    sample(&DirectionalMoments::a2, result.difference);
    sample(&DirectionalMoments::b2, result.cross);
  }
}

}  // namespace

double GroupTarget::squareNorm() const {
  double sum = 0.0;
  for (std::size_t p = 0; p < points(); ++p) sum += weight[p] * density[p] * density[p];
  return sum;
}

double GroupTarget::gridSquareNorm() const {
  const std::size_t count = direction.size();
  double sum = 0.0;
  for (std::size_t i = 0; i < grid.size(); ++i) sum += weight[i / count] * grid[i] * grid[i];
  return sum * 2.0 * std::numbers::pi / static_cast<double>(count);
}

double GroupTarget::moment(int n, const std::vector<double>& of) const {
  double sum = 0.0;
  for (std::size_t p = 0; p < points(); ++p) sum += weight[p] * std::pow(frequency[p], n) * of[p];
  return sum;
}

double GroupTarget::quantile(double share, double power) const {
  std::vector<double> cumulative(points(), 0.0);
  for (std::size_t p = 1; p < points(); ++p) {
    const double mean = 0.5 * (std::pow(density[p - 1], power) + std::pow(density[p], power));
    cumulative[p] = cumulative[p - 1] + mean * (frequency[p] - frequency[p - 1]);
  }
  return between(cumulative, share * cumulative.back()).of([&](std::size_t i) {
    return frequency[i];
  });
}

double narrowestBand(const FrequencySpectrum& target) {
  const auto peak = static_cast<std::size_t>(
      std::max_element(target.density.begin(), target.density.end()) - target.density.begin());
  std::size_t low = peak, high = peak;
  while (low > 0 && target.density[low] > 0.5 * target.density[peak]) --low;
  while (high + 1 < target.density.size() && target.density[high] > 0.5 * target.density[peak]) {
    ++high;
  }
  const double width = (target.frequency[high] - target.frequency[low]) / target.frequency[peak];
  return std::clamp(0.3 * width, 1e-3, 0.03);
}

GroupTarget sampleTarget(const DirectionalSpectrum& target, double depth, std::size_t points,
                         bool uniform) {
  GroupTarget result;
  result.variance = target.energy.moment(0);
  result.frequency = uniform ? uniformFrequencies(target.energy, points)
                             : crowdedFrequencies(target.energy, points);
  result.weight = trapezoidWeights(result.frequency);
  for (const double f : result.frequency) {
    result.waveNumber.push_back(waveNumber(2.0 * std::numbers::pi * f, depth));
    result.density.push_back(target.energy.at(f) / result.variance);
  }
  if (!target.moments.empty()) sampleMoments(target, result);
  if (!target.hasGrid()) return result;
  result.direction = target.direction;
  for (const double f : result.frequency) {
    const Between at = between(target.energy.frequency, f);
    for (std::size_t d = 0; d < target.direction.size(); ++d) {
      result.grid.push_back(at.of([&](std::size_t i) { return target.at(i, d); }) /
                            result.variance);
    }
  }
  return result;
}

}  // namespace seaway::fit
