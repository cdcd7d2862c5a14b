#pragma once

#include <random>
#include <vector>

#include "surface/hull/analytic_hulls.h"
#include "surface/hull/hull_loads.h"

/// Hulls and waters that tests of loads share.
namespace seaway::test {

inline constexpr double weightDensity = seaWaterDensity * standardGravity;
inline const WaterSurface& stillWater() {
  static const WaterSurface water{WaveField({})};
  return water;
}

inline HullModel model(const TriangleMesh& mesh, double mass,
                       LoadLevel level = LoadLevel::meshDynamic) {
  HullSettings settings;
  settings.level = level;
  settings.mass = mass;
  settings.centreOfGravity = massProperties(mesh).centroid;
  return {mesh, settings};
}

inline HullModel halfFloating(const TriangleMesh& mesh, LoadLevel level = LoadLevel::meshDynamic) {
  return model(mesh, 0.5 * seaWaterDensity * massProperties(mesh).volume, level);
}

inline glm::dquat randomAttitude(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  return glm::normalize(glm::dquat(normal(random), normal(random), normal(random), normal(random)));
}

inline WaterSurface groups(std::size_t count) {
  std::vector<Octave> octaves;
  for (std::size_t i = 0; i < count; ++i) {
    octaves.push_back(makeGroupOctave(0.3, 0.1 + 0.03 * static_cast<double>(i), 0.02,
                                      0.1 * static_cast<double>(i), 0.5));
  }
  return WaterSurface(WaveField(octaves, {.seed = 5}));
}

}  // namespace seaway::test
