#pragma once

#include <cmath>
#include <random>

#include "surface/constants.h"
#include "surface/spectra/families.h"
#include "tests/render/seas.h"

namespace seaway::render::test {

/// What a random view's sea is made of.
enum class SeaKind {
  perlin,  ///< eight Perlin octaves, see windSea
  group,   ///< 24 group octaves of a JONSWAP sea, the product's default model
};

/// A camera anywhere and a sea of any height: −20 m … 10 km up, any attitude, field of view 5° …
/// 120°, H_s 0 … 15 m. The camera of a number is the same whatever the sea is made of.
struct RandomView {
  WaterSurface water;
  Camera camera;
  double time;
  double waveHeight;        ///< H_s, m
  double yaw, pitch, roll;  ///< of the camera, as attitude() takes them, rad
};

/// JONSWAP (γ = 3.3) cut into bands of a tenth of their frequency from 0.7 to 6.3 f_p, one octave
/// each; directions spread over ±0.5 rad.
inline WaterSurface jonswapSea(double significantWaveHeight, double peakPeriod) {
  if (!(significantWaveHeight > 0.0)) return stillSea();
  const FrequencySpectrum spectrum = jonswap({significantWaveHeight, peakPeriod, 3.3});
  std::vector<Octave> octaves;
  for (int i = 0; i < 24; ++i) {
    const double frequency = 0.7 / peakPeriod * std::pow(1.1, i);
    const double band = frequency * (std::sqrt(1.1) - 1.0 / std::sqrt(1.1));
    octaves.push_back(makeGroupOctave(std::sqrt(spectrum.at(frequency) * band), frequency, band,
                                      0.3 + 0.5 * std::sin(2.4 * i), 0.5));
  }
  return WaterSurface(WaveField(octaves));
}

/// A sea whose length goes with its height as in nature: the peak's wavelength is 30 m + 18 H_s, so
/// that 15 m are a twentieth of theirs.
inline WaterSurface seaOfHeight(double significantWaveHeight, SeaKind kind) {
  if (kind == SeaKind::perlin) {
    return windSea(significantWaveHeight, 30.0 + 12.0 * significantWaveHeight);
  }
  const double wavelength = 30.0 + 18.0 * significantWaveHeight;
  return jonswapSea(significantWaveHeight, std::sqrt(2.0 * pi * wavelength / standardGravity));
}

inline RandomView randomView(std::uint64_t number, glm::ivec2 size,
                             SeaKind kind = SeaKind::perlin) {
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
  const double east = uniform(-1e4, 1e4), north = uniform(-1e4, 1e4);
  camera.position = {east, north, z};
  const double roll = uniform(-pi, pi), pitch = std::asin(uniform(-1.0, 1.0)),
               yaw = uniform(-pi, pi);
  camera.worldFromCamera = attitude(yaw, pitch, roll);
  camera.verticalFieldOfView = radiansFromDegrees(uniform(5.0, 120.0));
  camera.size = size;
  return {seaOfHeight(waveHeight, kind), camera, uniform(0.0, 1e5), waveHeight, yaw, pitch, roll};
}

}  // namespace seaway::render::test
