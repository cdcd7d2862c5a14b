#include "render/band_limit.h"

#include <algorithm>
#include <cmath>

#include "surface/angles.h"

namespace seaway::render {
namespace {

double smoothstep(double low, double high, double x) {
  const double f = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return f * f * (3.0 - 2.0 * f);
}

/// Mean square of an octave's slopes along its direction less that across it.
double slopeAheadOfAcross(const Octave& octave) {
  if (octave.kind == OctaveKind::perlin) return 0.0;  // the same all round
  const double carrier = std::pow(octave.standardDeviation * octave.waveNumber, 2);
  if (octave.kind == OctaveKind::regular) return carrier;
  // The rest is its envelope's, by 1/ℓ² along and across.
  const double along = std::pow(octave.lengthAlong, -2), across = std::pow(octave.lengthAcross, -2);
  return carrier + (meanSquareSlope(octave) - carrier) * (along - across) / (along + across);
}

}  // namespace

double coxMunkMeanSquareSlope(double windSpeed) { return 0.003 + 5.12e-3 * windSpeed; }

BandLimit::BandLimit(const WaveField& waves) {
  for (const Octave& octave : waves.octaves()) {
    octaves_.push_back({dominantWavelength(octave), meanSquareSlope(octave)});
    totalSlope_ += octaves_.back().slope;
    lean_ += slopeAheadOfAcross(octave) * unitVector(2.0 * octave.toward);
  }
  lean_ = totalSlope_ > 0.0 ? lean_ / totalSlope_ : glm::dvec2(0.0);
}

BandLimit::Plan BandLimit::planFor(double spacing) const {
  Plan plan;
  plan.spacing = spacing;
  plan.keptWavelength = plan.fadingWavelength = 4.0 * spacing;
  double keptSlope = 0.0, fadingSlope = 0.0, weighted = 0.0;
  for (const Entry& octave : octaves_) {
    if (octave.wavelength >= plan.keptWavelength) {
      keptSlope += octave.slope;
    } else if (octave.wavelength >= 2.0 * spacing) {
      fadingSlope += octave.slope;
      weighted += octave.slope * smoothstep(2.0 * spacing, 4.0 * spacing, octave.wavelength);
    }
  }
  if (fadingSlope > 0.0) {
    plan.fadingWavelength = 2.0 * spacing;
    plan.weight = weighted / fadingSlope;
  }
  plan.missingSlope =
      std::max(totalSlope_ - keptSlope - plan.weight * plan.weight * fadingSlope, 0.0);
  return plan;
}

}  // namespace seaway::render
