#pragma once

#include <cstddef>
#include <cstdint>
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
  /// rippleTexture and its mip levels, one after the other: slope x and y in 11 bits each of
  /// ±`rippleSpan`, √ of |slope|² in 10 bits of [0, rippleSpan].
  std::vector<std::uint32_t> ripples;
  static constexpr float rippleSpan = 5.0f;

  std::size_t memoryBytes() const;
};

const ShadingTables& shadingTables();

/// What a packed texel stands for: (slope x, slope y, |slope|²), as both shaders decode it.
struct RippleMoments {
  float x, y, square;
};
RippleMoments unpackRipple(std::uint32_t texel);

/// First texel of a level in a chain of square levels that starts with `side`, a power of two.
constexpr int levelStart(int side, int level) {
  const int here = side >> level;
  return (side * side - here * here) / 3 * 4;
}

}  // namespace seaway::render
