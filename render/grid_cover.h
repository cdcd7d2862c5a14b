#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

#include "surface/water_surface.h"

namespace seaway::render {

class Surf;

/// Points of a grid's row that are worked on together.
inline constexpr int gridChunk = 256;

/// What lies on the water along a piece of a grid's row.
struct GridCover {
  std::array<float, gridChunk> foam, damped, oil;
  std::array<float, gridChunk> smooth;
  bool any = false;    ///< whether anything lies anywhere; else the rest is not set
  bool damps = false;  ///< whether short waves are damped anywhere

  /// Samples the layers of `water` at the points (x, y), `gridChunk` of them at the most.
  void sample(const SurfaceAtTime& water, std::span<const double> x, std::span<const double> y);

  /// Adds surf at the same points, of the waves that a row of `keptWavelength` carries.
  void addSurf(const Surf& surf, const SurfaceAtTime& water, std::span<const double> x,
               std::span<const double> y, double keptWavelength);

  /// Foam, smoothed water and oil in the low three bytes.
  std::uint32_t packed(std::size_t i) const;
};

std::uint32_t packCover(glm::vec3 cover);

/// Heights and slopes of a piece of a row; `rate` is not used.
using GridWaves = FieldAtTime::Arrays;

/// Adds what disturbs waves that a row of `keptWavelength` m (BandLimit) carries: short waves
/// damped where `cover` says so, splashes and pools of ripples as far as the row carries them.
/// Rain is left to shading.
void addExtras(const SurfaceAtTime& water, std::span<const double> x, std::span<const double> y,
               double keptWavelength, const GridCover& cover, const GridWaves& waves);

/// Foam, surf's included unless that is null, smoothed water and oil at one place.
glm::vec3 coverAt(const SurfaceAtTime& water, const Surf* surf, glm::dvec2 point);

/// Whether anything may lie on the water at all.
bool mayHaveCover(const SurfaceExtras& extras, const Surf* surf);

}  // namespace seaway::render
