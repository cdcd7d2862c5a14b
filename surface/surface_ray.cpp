#include "surface/surface_ray.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "surface/constants.h"
#include "surface/curvature.h"

namespace seaway {

std::optional<double> distanceToWater(const SurfaceAtTime& water, glm::dvec3 origin,
                                      glm::dvec3 direction, const RayOptions& options) {
  const double level = glm::length(glm::dvec2(direction));
  const TerrainMap* terrain = water.terrain();
  const double bound = std::max(water.heightBound(), terrain ? terrain->highest() : 0.0);
  double meanSquare = 0.0;
  for (const Octave& octave : water.waves().field().octaves())
    meanSquare += meanSquareSlope(octave);
  const double steepest =
      std::max(6.0 * std::sqrt(meanSquare), terrain ? terrain->steepest() : 0.0);
  const double curvature = options.curved ? 1.0 / earthMeanRadius : 0.0;

  const auto aboveStillWater = [&](double distance) {
    return origin.z + direction.z * distance + (options.curved ? seaDrop(level * distance) : 0.0);
  };
  const auto at = [&](double distance) {
    return water.sample(glm::dvec2(origin) + glm::dvec2(direction) * distance,
                        {.derivatives = false});
  };
  const auto aboveWater = [&](double distance) {
    const SurfaceSample sample = at(distance);
    if (!has(sample.status, SampleStatus::dry)) return aboveStillWater(distance) - sample.height;
    const glm::dvec2 foot = glm::dvec2(origin) + glm::dvec2(direction) * distance;
    const bool outside = !water.outline() || !water.outline()->contains(foot);
    const double shore = water.outline() && outside ? 0.0 : -bound;
    const double ground = terrain ? terrain->heightAt(foot) : 0.0;
    return aboveStillWater(distance) - std::max(ground, shore);
  };

  double before = options.nearDistance;
  const double startHeight = aboveWater(before);
  const double side = startHeight < 0.0 ? -1.0 : 1.0;  // +1: looking from above
  double height = startHeight;
  while (before < options.farDistance) {
    // Farther away than the highest crest, still water tells how far the next step may go.
    const double clear = side * aboveStillWater(before) - bound;
    const double sinking = std::abs(direction.z) + level * level * before * curvature + 1e-12;
    const double step = std::max(clear / sinking, side * height / (sinking + level * steepest));
    const double capped = std::min(step, options.farDistance);
    const double next = before + std::max({capped, options.leastStep * before, options.tolerance});
    const double nextHeight = aboveWater(next);
    if (side * nextHeight <= 0.0) {
      double low = before, high = next;
      while (high - low > options.tolerance) {
        const double middle = 0.5 * (low + high);
        (side * aboveWater(middle) > 0.0 ? low : high) = middle;
      }
      const double hit = 0.5 * (low + high);
      if (has(at(hit).status, SampleStatus::dry)) return std::nullopt;
      return hit;
    }
    before = next;
    height = nextHeight;
  }
  return std::nullopt;
}

}  // namespace seaway
