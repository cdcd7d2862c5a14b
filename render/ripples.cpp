#include "render/ripples.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render/band_limit.h"
#include "surface/angles.h"
#include "surface/constants.h"

namespace seaway::render {
namespace {

constexpr int leastCycles = 8, mostCycles = 56;  // of ripples across the patch

/// Small generator of our own: the standard library's distributions differ between libraries.
class Draw {
 public:
  double next() {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return static_cast<double>(state_ >> 11) * 0x1p-53;
  }

 private:
  std::uint64_t state_ = 0x5EA3A1u;
};

struct Ripple {
  glm::dvec2 cycles;  // whole numbers, so that the patch tiles
  double phase;
};

std::vector<Ripple> drawRipples() {
  std::vector<Ripple> ripples;
  Draw draw;
  while (ripples.size() < 72) {
    const double length = leastCycles * std::pow(double{mostCycles} / leastCycles, draw.next());
    const double angle = (draw.next() + draw.next() + draw.next() - 1.5) * pi;  // mostly along +x
    ripples.push_back({glm::round(length * unitVector(angle)), 2.0 * pi * draw.next()});
  }
  return ripples;
}

}  // namespace

std::vector<glm::vec3> rippleTexture(int side) {
  const std::vector<Ripple> ripples = drawRipples();
  std::vector<glm::dvec2> slopes(static_cast<std::size_t>(side) * side, glm::dvec2(0.0));
  std::vector<double> cosines(side);
  for (const Ripple& ripple : ripples) {
    const glm::dvec2 direction = ripple.cycles / glm::length(ripple.cycles);
    // Cycles are whole: a texel's phase is one of `side`.
    for (int i = 0; i < side; ++i) cosines[i] = std::cos(2.0 * pi * i / side + ripple.phase);
    const auto wrapped = [&](double cycles) {
      const int steps = static_cast<int>(cycles) % side;
      return steps < 0 ? steps + side : steps;
    };
    const int across = wrapped(ripple.cycles.x), down = wrapped(ripple.cycles.y);
    for (int y = 0; y < side; ++y) {
      int at = down * y % side;
      for (int x = 0; x < side; ++x) {
        slopes[static_cast<std::size_t>(y) * side + x] += direction * cosines[at];
        at += at + across < side ? across : across - side;
      }
    }
  }
  double meanSquare = 0.0;
  for (const glm::dvec2 slope : slopes) meanSquare += glm::dot(slope, slope) / slopes.size();
  const double scale = 1.0 / std::sqrt(meanSquare);
  std::vector<glm::vec3> texels;
  texels.reserve(slopes.size());
  for (const glm::dvec2 slope : slopes) {
    texels.emplace_back(slope * scale, glm::dot(slope, slope) * scale * scale);
  }
  return texels;
}

glm::dvec2 Ripples::textureCoordinate(int layer, glm::dvec2 point, double time) const {
  return glm::fract(textureFromWorld[layer] * (point - drift[layer] * time));
}

Ripples ripplesFor(const WaveField& waves, double windSpeed) {
  double shortest = 1.5, towards = 0.0;
  if (!waves.octaves().empty()) {
    towards = waves.octaves().front().toward;
    shortest = 1e300;
    for (const Octave& octave : waves.octaves()) {
      shortest = std::min(shortest, dominantWavelength(octave));
    }
  }
  Ripples ripples;
  const double missing =
      std::max(coxMunkMeanSquareSlope(windSpeed) - BandLimit(waves).totalSlope(), 0.0);
  ripples.layerSlope = 0.32 * missing;
  ripples.hairSlope = missing - 2.0 * ripples.layerSlope;
  const double side = std::clamp(leastCycles * shortest, 2.0, 14.0);
  const double sides[2] = {side, 0.331 * side};
  const double turned[2] = {0.4, -0.5};
  for (int layer = 0; layer < 2; ++layer) {
    const double angle = towards + turned[layer];
    const glm::dvec2 along = unitVector(angle);
    // Columns of the inverse are the patch's sides in the sea plane.
    ripples.textureFromWorld[layer] =
        glm::dmat2(along.x, -along.y, along.y, along.x) / sides[layer];
    const double wavelength = sides[layer] / 20.0;
    ripples.drift[layer] = along * std::sqrt(standardGravity * wavelength / (2.0 * pi));
  }
  return ripples;
}

}  // namespace seaway::render
