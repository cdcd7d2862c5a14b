#include "surface/field/group_spectrum.h"

#include <cmath>
#include <cstddef>
#include <vector>

#include "surface/constants.h"

namespace seaway {
namespace {

constexpr double largestQ = 4.0;
constexpr double stepQ = 0.004;

/// Fourier transform of cos(½π·fade(|u|)) on [−1, 1], midpoint rule.
double transform(double q) {
  constexpr int steps = 512;
  double sum = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double u = (i + 0.5) / steps;
    const double fade = u * u * u * (u * (u * 6.0 - 15.0) + 10.0);
    sum += std::cos(0.5 * pi * fade) * std::cos(2.0 * pi * q * u);
  }
  return 2.0 * sum / steps;
}

std::vector<double> makeTable() {
  std::vector<double> table;
  const auto count = static_cast<std::size_t>(std::lround(largestQ / stepQ)) + 1;
  for (std::size_t i = 0; i < count; ++i) {
    const double value = transform(static_cast<double>(i) * stepQ);
    table.push_back(value * value);
  }
  return table;
}

}  // namespace

double groupEnvelopeDensity(double q) {
  static const std::vector<double> table = makeTable();
  const double at = std::abs(q) / stepQ;
  const auto i = static_cast<std::size_t>(at < 1e9 ? at : 1e9);
  if (!(at >= 0.0) || i + 1 >= table.size()) return 0.0;
  const double fraction = at - static_cast<double>(i);
  return table[i] * (1.0 - fraction) + table[i + 1] * fraction;
}

}  // namespace seaway
