#include "surface/spectra/directional_spread.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "surface/constants.h"

namespace seaway {

double spreadQuantile(double exponent, double quantile) {
  if (std::isinf(exponent)) return 0.0;
  constexpr int cells = 8192;
  std::vector<double> cumulative(cells + 1, 0.0);
  const auto angle = [](int i) { return pi * (2.0 * i / cells - 1.0); };
  const auto density = [&](int i) {
    return std::pow(std::max(0.0, std::cos(angle(i) / 2.0)), 2.0 * exponent);
  };
  for (int i = 0; i < cells; ++i) {
    cumulative[i + 1] = cumulative[i] + 0.5 * (density(i) + density(i + 1));
  }
  const double wanted = quantile * cumulative.back();
  const auto above = std::upper_bound(cumulative.begin() + 1, cumulative.end() - 1, wanted);
  const int i = static_cast<int>(above - cumulative.begin()) - 1;
  const double width = cumulative[i + 1] - cumulative[i];
  const double fraction = width > 0.0 ? (wanted - cumulative[i]) / width : 0.5;
  return angle(i) + fraction * (2.0 * pi / cells);
}

double vanDerCorput(unsigned n) {
  double value = 0.0;
  double digit = 0.5;
  for (unsigned rest = n + 1; rest != 0; rest >>= 1, digit *= 0.5) {
    if (rest & 1u) value += digit;
  }
  return value;
}

}  // namespace seaway
