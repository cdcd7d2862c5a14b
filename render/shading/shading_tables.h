#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

namespace seaway::render {

/// Tables that the water's shading looks up, packed so that one fetch brings a texel. The same for
/// all scenes: made once.
struct ShadingTables {
  static constexpr int fresnelColumns = 128, fresnelRows = 32;
  static constexpr int rippleSide = 256;
  /// Level 5 is 8 texels wide, below which no ripple is left: levels 0…4 are stored.
  static constexpr int rippleLevels = 6;

  /// roughReflection by √cosine and slope deviation: reflectance in the low 16 bits, tilt in the
  /// high ones (both of [0, 1]), and the area.
  std::vector<std::uint32_t> mirror;
  std::vector<float> area;
  /// Slopes of rippleTexture and its mip levels, one after the other: x in the low 16 bits and y in
  /// the high ones, signed, in steps of rippleSpan/32767.
  std::vector<std::uint32_t> ripples;
  static constexpr float rippleSpan = 5.0f;
  /// Mean-square slope that bilinear filtering leaves of each level, of 1 before it; the last none.
  float rippleKept[rippleLevels] = {};

  std::size_t memoryBytes() const;
};

const ShadingTables& shadingTables();

/// What foam's shading looks up. The same for all scenes: made when foam is first shaded.
struct FoamTable {
  static constexpr int side = 256, levels = 6;
  std::vector<float> texels;  ///< foamPattern and its mip levels, one after the other
  float kept[levels] = {};    ///< part of the pattern's variance that is left in each
};

const FoamTable& foamTable();

/// Slope that a packed texel stands for.
glm::vec2 unpackRipple(std::uint32_t texel);

/// First texel of a level in a chain of square levels that starts with `side`, a power of two.
constexpr int levelStart(int side, int level) {
  const int here = side >> level;
  return (side * side - here * here) / 3 * 4;
}

}  // namespace seaway::render
