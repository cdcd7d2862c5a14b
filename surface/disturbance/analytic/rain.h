#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <limits>

namespace seaway {

/// Rings of raindrops: a pure function of place and time. The plane is divided into cells, each
/// with a few drops that fall over and over again at other places; a ring stays within half a cell
/// of its drop, so that the four nearest cells tell all there is at a point. Drops are told apart
/// by the lattice hash of the wave field (surface/field/lattice_hash.h).
///
/// Samples have the rings' heights, 3 mm at the most; pictures show the same rings by their slopes
/// (render/shading/rain_rings.h).
struct Rain {
  static constexpr double cell = 0.6;          ///< m
  static constexpr int mostDrops = 6;          ///< a cell
  static constexpr double lifetime = 0.9;      ///< of a ring, s
  static constexpr double speed = 0.25;        ///< at which a ring widens, m/s
  static constexpr double wavelength = 0.055;  ///< of its ripples, m
  static constexpr double halfWidth = 0.07;    ///< of the packet of ripples, m
  static constexpr double ringHeight = 0.003;  ///< of a young ring, m

  /// For rain of `rate` mm/h, ≥ 0: drops large enough to leave a ring that is seen, `mostDrops` in
  /// a cell from 50 mm/h on (a look, not a measured spectrum of drops).
  static Rain ofRate(double rate, std::uint64_t seed);

  double drops = 0.0;  ///< a cell, mean, [0, mostDrops]
  std::uint32_t seed = 0;
  double from = -std::numeric_limits<double>::infinity();  ///< falls from then, s
  double to = std::numeric_limits<double>::infinity();     ///< till then, s

  bool falls() const { return drops > 0.0; }
  bool falls(double t) const { return falls() && t >= from && t < to; }

  /// Height, m, and its derivatives. Zero where point or time are not finite.
  struct Value {
    float height = 0.0f, slopeX = 0.0f, slopeY = 0.0f, rate = 0.0f;
  };
  Value at(glm::dvec2 point, double t) const noexcept;

  /// A drop of a cell at a time.
  struct Drop {
    float x = 0.0f, y = 0.0f;  ///< m from the cell's lower corner
    float age = 0.0f;          ///< s since it fell, [0, lifetime)
    bool falls = false;
  };
  /// `slot` in [0, mostDrops); `t` finite.
  Drop drop(std::int64_t i, std::int64_t j, int slot, double t) const noexcept;

  /// Height and derivatives of one ring at `r` m from its drop, by distance and by time.
  struct Ring {
    float height, byDistance, byTime;
  };
  static Ring ring(float r, float age) noexcept;

  /// Mean-square slope of all rings, both axes together (rain_test.cpp measures it).
  double meanSquareSlope() const { return drops * slopePerDrop; }
  static constexpr double slopePerDrop = 4.2e-4;
};

}  // namespace seaway
