#pragma once

#include <cmath>
#include <random>

#include "tests/render/seas.h"

namespace seaway::render::test {

/// A camera anywhere and a sea of any height: −20 m … 10 km up, any attitude, field of view 5° …
/// 120°, H_s 0 … 15 m.
struct RandomView {
  WaterSurface water;
  Camera camera;
  double time;
};

inline RandomView randomView(std::uint64_t number, glm::ivec2 size) {
  std::mt19937_64 random(number * 7919 + 1);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * (static_cast<double>(random() >> 11) * 0x1p-53);
  };
  const double waveHeight = uniform(0.0, 15.0);
  const double heights = uniform(0.0, 1.0);  // a fifth below, most within 30 m, some far above
  const double z = heights < 0.15  ? uniform(-20.0, 0.0)
                   : heights < 0.6 ? uniform(0.0, 30.0)
                                   : std::pow(10.0, uniform(1.5, 4.0));
  Camera camera;
  camera.position = {uniform(-1e4, 1e4), uniform(-1e4, 1e4), z};
  camera.worldFromCamera =
      attitude(uniform(-pi, pi), std::asin(uniform(-1.0, 1.0)), uniform(-pi, pi));
  camera.verticalFieldOfView = radiansFromDegrees(uniform(5.0, 120.0));
  camera.size = size;
  const double longest = 30.0 + 12.0 * waveHeight;  // waves of a plausible steepness
  return {windSea(waveHeight, longest), camera, uniform(0.0, 1e5)};
}

}  // namespace seaway::render::test
