#include "render/grid_error.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <numbers>

#include "surface/angles.h"

namespace seaway::render {
namespace {

/// Part of an octave that a row's vertices carry.
double carried(const BandLimit::Plan& plan, double wavelength) {
  if (wavelength >= plan.keptWavelength) return 1.0;
  return wavelength >= plan.fadingWavelength ? plan.weight : 0.0;
}

/// A wave of amplitude 1, as seen from one of its places.
std::complex<double> waveAt(double phase) { return std::polar(1.0, phase); }

/// Such a wave from the triangle's corners that a place lies in, of a quad whose vertices are
/// `across` rad apart along a row and `along` rad from row to row; parts of the way in [0, 1]. The
/// near row carries it times `weights.x`, the far one times `weights.y`. Quads are cut from the
/// near row's second vertex to the far row's first.
std::complex<double> drawn(double across, double along, glm::dvec2 part, glm::dvec2 weights) {
  const std::complex<double> here = waveAt(-part.x * across - part.y * along);
  const std::complex<double> near = here * weights.x, second = near * waveAt(across);
  const std::complex<double> first = here * waveAt(along) * weights.y;
  if (part.x + part.y <= 1.0) {
    return near * (1.0 - part.x - part.y) + second * part.x + first * part.y;
  }
  const std::complex<double> last = first * waveAt(across);
  return last * (part.x + part.y - 1.0) + second * (1.0 - part.y) + first * (1.0 - part.x);
}

}  // namespace

GridError::GridError(const WaveField& waves, const GridLayout& layout) : layout_(layout) {
  for (const Octave& octave : waves.octaves()) {
    const double variance = std::pow(octave.standardDeviation, 2);
    const double wavelength = dominantWavelength(octave);
    const auto add = [&](double share, glm::dvec2 waveNumber) {
      waves_.push_back({share * variance, wavelength, waveNumber});
    };
    if (octave.kind == OctaveKind::regular) {
      add(1.0, octave.waveNumber * unitVector(octave.toward));
    } else if (octave.kind == OctaveKind::perlin) {
      constexpr int around = 8;  // directions that stand for all
      // Two wave numbers that have the mean square of perlinWaveNumberDensity and its mean fourth
      // power, 1.52 of the square of that.
      const double square = meanSquareSlope(octave) / variance, apart = std::sqrt(0.52);
      for (const double part : {1.0 - apart, 1.0 + apart}) {
        for (int i = 0; i < around; ++i) {
          add(0.5 / around,
              std::sqrt(part * square) * unitVector(octave.toward + i * std::numbers::pi / around));
        }
      }
    } else {
      // The envelope spreads the carrier, by 1/ℓ each way: Gauss' three points for each.
      const double along = std::pow(octave.lengthAlong, -2);
      const double across = std::pow(octave.lengthAcross, -2);
      const double excess = meanSquareSlope(octave) / variance - std::pow(octave.waveNumber, 2);
      const double each = std::sqrt(std::max(excess, 0.0) / (along + across));
      const glm::dvec2 ahead = unitVector(octave.toward), aside(-ahead.y, ahead.x);
      for (int i = -1; i <= 1; ++i) {
        for (int j = -1; j <= 1; ++j) {
          const glm::dvec2 off =
              each * std::numbers::sqrt3 * glm::dvec2(i, j) * glm::sqrt(glm::dvec2(along, across));
          add((i == 0 ? 2.0 / 3.0 : 1.0 / 6.0) * (j == 0 ? 2.0 / 3.0 : 1.0 / 6.0),
              (octave.waveNumber + off.x) * ahead + off.y * aside);
        }
      }
    }
  }
}

double GridError::standardDeviationAt(glm::dvec2 place) const {
  const int row = std::min(static_cast<int>(layout_.rowAt(place)), layout_.size.y - 2);
  const GridLayout::Row &near = layout_.rows[row], &far = layout_.rows[row + 1];
  const glm::dvec2 azimuth = layout_.fromPlane.azimuth;
  const double depth = glm::dot(far.start - near.start, azimuth);
  const double beyond =
      depth > 0.0 ? std::clamp(glm::dot(place - near.start, azimuth) / depth, 0.0, 1.0) : 0.0;
  const glm::dvec2 step = glm::mix(near.step, far.step, beyond);
  const double columns = std::clamp(
      glm::dot(place - glm::mix(near.start, far.start, beyond), step) / glm::dot(step, step), 0.0,
      layout_.size.x - 1.0);
  const double column = std::min(std::floor(columns), layout_.size.x - 2.0);
  const glm::dvec2 part(columns - column, beyond);
  const glm::dvec2 along = far.start - near.start + columns * (far.step - near.step);
  double variance = 0.0;
  for (const Wave& wave : waves_) {
    const glm::dvec2 weights(carried(near.plan, wave.wavelength),
                             carried(far.plan, wave.wavelength));
    const double across = glm::dot(wave.waveNumber, step), on = glm::dot(wave.waveNumber, along);
    variance += wave.variance * std::norm(1.0 - drawn(across, on, part, weights));
  }
  return std::sqrt(variance);
}

}  // namespace seaway::render
