#include "surface/whitecaps.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "surface/angles.h"
#include "surface/constants.h"

namespace seaway {
namespace {

/// ∫ₓ^∞ (b − x) φ(b) db of the normal density φ: how much of it lies above x.
double excess(double x) {
  const double density = std::exp(-0.5 * x * x) / std::sqrt(2.0 * pi);
  return density - x * 0.5 * std::erfc(x / std::sqrt(2.0));
}

/// The threshold from which a ramp has a mean of `mean` over a normal variable.
WhitecapRule::Ramp rampOfMean(double mean, double width, double most) {
  double low = -5.0, high = 9.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    const double here = most * (excess(middle) - excess(middle + width)) / width;
    (here > mean ? low : high) = middle;
  }
  return {0.5 * (low + high), width, most};
}

/// Of all foam, what is breaking at the moment and what it has left.
constexpr double breakingPart = 0.4;

}  // namespace

double whitecapCover(double windSpeed) {
  if (!(windSpeed > 0.0)) return 0.0;
  return std::min(3.84e-6 * std::pow(windSpeed, 3.41), 1.0);
}

double WhitecapRule::Ramp::at(double x) const {
  return most * std::clamp((x - threshold) / width, 0.0, 1.0);
}

WhitecapRule::WhitecapRule(const WaveField& waves, double windSpeed) {
  const double cover = whitecapCover(windSpeed);
  // Waves of less than a few centimetres do not break into foam.
  if (waves.standardDeviation() < 0.02 || cover < 1e-5) return;
  glm::dvec2 sum(0.0);
  for (const Octave& octave : waves.octaves()) {
    sum += octave.standardDeviation * octave.standardDeviation * unitVector(octave.toward);
  }
  if (glm::length(sum) > 0.0) toward = glm::normalize(sum);
  double alongSquare = 0.0;
  for (const Octave& octave : waves.octaves()) {
    const double along = glm::dot(unitVector(octave.toward), toward);
    const double share = octave.kind == OctaveKind::perlin ? 0.5 : along * along;
    alongSquare += share * meanSquareSlope(octave);
  }
  mean = cover;
  perHeight = 1.0 / waves.standardDeviation();
  perSlope = alongSquare > 0.0 ? 1.0 / std::sqrt(alongSquare) : 0.0;
  breaking = rampOfMean(breakingPart * cover, 1.4, 0.8);
  old = rampOfMean((1.0 - breakingPart) * cover, 1.8, 0.5);
}

double WhitecapRule::cover(double height, glm::dvec2 slope) const {
  const double up = height * perHeight, ahead = -glm::dot(slope, toward) * perSlope;
  const double crests = perHeight > 0.0 ? breaking.at(aheadCosine * up + aheadSine * ahead) +
                                              old.at(behindCosine * up - behindSine * ahead)
                                        : 0.0;
  const double steepness = (glm::length(slope) - steep) / (allSteep - steep);
  return std::clamp(std::max(crests, steepness), 0.0, 1.0);
}

}  // namespace seaway
