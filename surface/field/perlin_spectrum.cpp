#include "surface/field/perlin_spectrum.h"

#include <cmath>
#include <cstddef>
#include <vector>

#include "surface/constants.h"

namespace seaway {
namespace {

constexpr double largestQ = 4.0;
constexpr double stepQ = 0.005;

/// Interpolation weight of a corner at distance u, |u| ≤ 1.
double cornerWeight(double u) {
  const double a = std::abs(u);
  return 1.0 - a * a * a * (a * (a * 6.0 - 15.0) + 10.0);
}

/// ∫ f over [0, 1], midpoint rule.
template <typename F>
double integrate01(F f) {
  constexpr int steps = 256;
  double sum = 0.0;
  for (int i = 0; i < steps; ++i) sum += f((i + 0.5) / steps);
  return sum / steps;
}

/// Squared Fourier transforms of w and of u·w at one wave number along an axis.
struct AxisPower {
  double even, odd;
};

AxisPower axisPower(double q) {
  const double even =
      integrate01([&](double u) { return 2.0 * cornerWeight(u) * std::cos(2.0 * pi * q * u); });
  const double odd =
      integrate01([&](double u) { return 2.0 * u * cornerWeight(u) * std::sin(2.0 * pi * q * u); });
  return {even * even, odd * odd};
}

class Table {
 public:
  Table() {
    const auto count = static_cast<std::size_t>(std::lround(largestQ / stepQ)) + 1;
    for (std::size_t i = 0; i < count; ++i) axis_.push_back(axisPower(i * stepQ));
    const double m0 = 2.0 * integrate01([](double u) { return cornerWeight(u) * cornerWeight(u); });
    const double m2 =
        2.0 * integrate01([](double u) { return u * u * cornerWeight(u) * cornerWeight(u); });
    for (std::size_t i = 0; i < count; ++i) density_.push_back(ring(i * stepQ, m0 * m2));
  }

  double operator()(double q) const {
    if (!(q >= 0.0) || q >= largestQ) return 0.0;
    const auto i = static_cast<std::size_t>(q / stepQ);
    const double fraction = q / stepQ - i;
    return density_[i] * (1.0 - fraction) + density_[i + 1] * fraction;
  }

 private:
  AxisPower at(double q) const {
    const auto i = static_cast<std::size_t>(q / stepQ);
    if (i + 1 >= axis_.size()) return axis_.back();
    const double fraction = q / stepQ - i;
    return {axis_[i].even * (1.0 - fraction) + axis_[i + 1].even * fraction,
            axis_[i].odd * (1.0 - fraction) + axis_[i + 1].odd * fraction};
  }

  /// Integral over the ring |q|, divided by the variance 2 m₂ m₀ of the noise.
  double ring(double q, double m0m2) const {
    const double mean = integrate01([&](double quarter) {
      const double angle = 0.5 * pi * quarter;
      const AxisPower x = at(q * std::cos(angle)), y = at(q * std::sin(angle));
      return x.odd * y.even + x.even * y.odd;
    });
    return 2.0 * pi * q * mean / (2.0 * m0m2);
  }

  std::vector<AxisPower> axis_;
  std::vector<double> density_;
};

}  // namespace

double perlinWaveNumberDensity(double q) {
  static const Table table;
  return table(q);
}

}  // namespace seaway
