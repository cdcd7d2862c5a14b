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

/// Where |q| lies in the table: entries i and i + 1, `fraction` between them; i is the last entry
/// where q is beyond the table.
struct Place {
  std::size_t i = 0;
  double fraction = 0.0;
};

const std::vector<double>& table() {
  static const std::vector<double> values = makeTable();
  return values;
}

Place placeOf(double q) {
  const double at = std::abs(q) / stepQ;
  const std::size_t last = table().size() - 1;
  if (!(at < static_cast<double>(last))) return {last, 0.0};
  const auto i = static_cast<std::size_t>(at);
  return {i, at - static_cast<double>(i)};
}

}  // namespace

double groupEnvelopeDensity(double q) {
  const Place at = placeOf(q);
  if (at.i + 1 >= table().size()) return 0.0;
  return table()[at.i] * (1.0 - at.fraction) + table()[at.i + 1] * at.fraction;
}

double groupEnvelopeSlope(double q) {
  const Place at = placeOf(q);
  if (at.i + 1 >= table().size()) return 0.0;
  return (table()[at.i + 1] - table()[at.i]) / std::copysign(stepQ, q);
}

}  // namespace seaway
