#include "surface/fit/octave_directions.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "surface/constants.h"

namespace seaway {
namespace {

constexpr double alternation = 0.15;  // of θ, about its mean: no two crossing trains everywhere

// Of those that stand alone: they overlap widely in the tail, where different wave numbers at one
// frequency lower the coherence of heave and slope, which reads as spread already.
constexpr double aloneAngle = 0.5;

double variance(const Octave& octave) {
  return octave.standardDeviation * octave.standardDeviation;
}

/// r₁ of a group octave alone: 1/√(1 + ⟨k⊥²⟩/k²), from the slopes of an endless group.
double ownFirstMoment(Octave octave) {
  octave.standardDeviation = 1.0;
  octave.lengthAlong = std::numeric_limits<double>::infinity();
  return octave.waveNumber / std::sqrt(meanSquareSlope(octave));
}

/// Angles in units of the pairs' mean. The last of an odd number that stand alone stays in the
/// middle: nothing would balance it.
std::vector<double> relativeAngles(const std::vector<bool>& paired) {
  std::vector<double> angles;
  std::size_t alone = 0, last = 0;
  for (std::size_t i = 0; i < paired.size(); ++i) {
    angles.push_back(i % 2 == 0 ? 1.0 - alternation : 1.0 + alternation);
    if (paired[i]) continue;
    angles.back() *= aloneAngle;
    ++alone;
    last = i;
  }
  if (alone % 2 == 1) angles[last] = 0.0;
  return angles;
}

/// Mean angle for which the pairs have Σa² r cos θ / Σa² = `wanted`; 0 where the octaves' own
/// widths already give less, and without pairs. Bisection: the sum falls with the angle.
double meanAngle(const std::vector<Octave>& octaves, const std::vector<bool>& paired,
                 const std::vector<double>& relative, const std::vector<double>& wanted) {
  const auto excess = [&](double angle) {
    double sum = 0.0;
    for (std::size_t i = 0; i < octaves.size(); ++i) {
      if (!paired[i]) continue;
      sum += variance(octaves[i]) *
             (ownFirstMoment(octaves[i]) * std::cos(angle * relative[i]) - wanted[i]);
    }
    return sum;
  };
  double widest = 1.0 + alternation;
  for (const double angle : relative) widest = std::max(widest, angle);
  double low = 0.0, high = pi / widest;
  for (int step = 0; step < 50; ++step) {
    const double middle = 0.5 * (low + high);
    (excess(middle) > 0.0 ? low : high) = middle;
  }
  return low;
}

std::vector<bool> strongest(const std::vector<Octave>& octaves, std::size_t count) {
  std::vector<std::size_t> order(octaves.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return octaves[a].standardDeviation > octaves[b].standardDeviation;
  });
  std::vector<bool> chosen(octaves.size(), false);
  for (std::size_t i = 0; i < std::min(count, order.size()); ++i) chosen[order[i]] = true;
  return chosen;
}

}  // namespace

double directionalWidthFor(double exponent) {
  const double firstMoment = std::isinf(exponent) ? 1.0 : exponent / (exponent + 1.0);
  return std::clamp(std::sqrt(2.0 * (1.0 - firstMoment)), 0.05, 0.35);
}

std::vector<Octave> spreadDirections(const std::vector<Octave>& octaves, double exponent,
                                     std::size_t count) {
  if (std::isinf(exponent)) return octaves;
  return spreadDirections(
      octaves, [=](const Octave&) { return exponent; }, count);
}

std::vector<Octave> spreadDirections(const std::vector<Octave>& octaves,
                                     const std::function<double(const Octave&)>& exponentOf,
                                     std::size_t count) {
  if (octaves.empty()) return {};
  const std::size_t pairs = count > octaves.size() ? count - octaves.size() : 0;
  const std::vector<bool> paired = strongest(octaves, pairs);
  std::vector<double> relative = relativeAngles(paired), firstMoment;
  for (const Octave& octave : octaves) {
    const double exponent = exponentOf(octave);
    firstMoment.push_back(exponent / (exponent + 1.0));
  }
  // In units of the widest: 1 throughout where the exponent is one.
  const double widest = std::acos(*std::min_element(firstMoment.begin(), firstMoment.end()));
  for (std::size_t i = 0; i < relative.size(); ++i) {
    relative[i] *= std::acos(firstMoment[i]) / widest;
  }
  const double angle = meanAngle(octaves, paired, relative, firstMoment);
  std::vector<Octave> spread;
  double leaning = 0.0;  // Σ a² sin θ of those that stand alone
  for (std::size_t i = 0; i < octaves.size(); ++i) {
    const double theta = angle * relative[i];
    Octave octave = octaves[i];
    if (paired[i]) {
      octave.standardDeviation /= std::sqrt(2.0);
      octave.toward += theta;
      spread.push_back(octave);
      octave.toward -= 2.0 * theta;
    } else {
      const double side = leaning > 0.0 ? -1.0 : 1.0;
      leaning += side * variance(octave) * std::sin(theta);
      octave.toward += side * theta;
    }
    spread.push_back(octave);
  }
  return spread;
}

}  // namespace seaway
