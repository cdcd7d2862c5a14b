#pragma once

#include <vector>

#include "sim_bridge/scene/scene.h"
#include "surface/field/blocked_octaves.h"
#include "surface/geodesy.h"
#include "surface/water_surface.h"

namespace seaway::bridge {

/// The sea of a scene, ready to be asked.
struct Sea {
  Geodesy geodesy;
  SeaLevel level;
  WaterSurface surface;
  double hm0Asked = 0.0;  ///< m; 0 where the scene asks for flat water or switches waves off
  std::vector<BlockedOctave> blocked;  ///< octaves that the current stops
};

/// Builds the sea: parametric states are fitted with group octaves on S(f), or with Perlin octaves
/// on S(k), as the scene's `sea.model` says. Group octaves get the spreading function's mean and
/// first moment at every frequency that matters (spreadDirections), Perlin octaves its quantiles in
/// a low-discrepancy order. Warns (spdlog) of octaves that the current stops. Throws InputError,
/// with file and line of the sea's state, where the state cannot be fitted or is no field.
Sea buildSea(const Scene& scene);

/// H_m0 = 4σ of what the surface really gives, m: from 65 536 samples over 400 of its longest
/// lattice cells each way and many times. Its own scatter is below 0.5 % (a test says so). Same
/// bits for the same surface.
double realisedSignificantWaveHeight(const WaterSurface& surface);

}  // namespace seaway::bridge
