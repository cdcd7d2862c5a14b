#include "surface/dispersion.h"

#include <algorithm>
#include <cmath>

#include "surface/constants.h"

namespace seaway {
namespace {

/// 2kd / sinh(2kd) without overflow; 0 in deep water.
double shallowness(double kd) {
  const double x = 2.0 * kd;
  return x > 700.0 ? 0.0 : x / std::sinh(x);
}

}  // namespace

double angularFrequency(double waveNumber, double depth) {
  return std::sqrt(standardGravity * waveNumber * std::tanh(waveNumber * depth));
}

double waveNumber(double angularFrequency, double depth) {
  const double deep = angularFrequency * angularFrequency / standardGravity;
  if (std::isinf(depth)) return deep;
  double k = std::max(deep, angularFrequency / std::sqrt(standardGravity * depth));
  for (int i = 0; i < 50; ++i) {
    const double tanhKd = std::tanh(k * depth);
    const double value = k * tanhKd - deep;
    const double derivative = tanhKd + k * depth * (1.0 - tanhKd * tanhKd);
    const double step = value / derivative;
    k -= step;
    if (std::abs(step) <= 1e-15 * k) break;
  }
  return k;
}

double phaseSpeed(double waveNumber, double depth) {
  return angularFrequency(waveNumber, depth) / waveNumber;
}

double groupSpeed(double waveNumber, double depth) {
  const double n = std::isinf(depth) ? 0.5 : 0.5 * (1.0 + shallowness(waveNumber * depth));
  return n * phaseSpeed(waveNumber, depth);
}

}  // namespace seaway
