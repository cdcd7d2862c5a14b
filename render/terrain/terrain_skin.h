#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "surface/terrain/terrain_map.h"

namespace seaway::render {

/// Slope and colour of a terrain's cells, with ever coarser levels for pixels that are wider than a
/// cell: shading keeps what the mesh leaves out. Immutable; shaders read the same texels.
class TerrainSkin {
 public:
  struct Colour {
    std::uint8_t red, green, blue, unused;  ///< √ of the linear reflectance, 255 being 1
  };
  struct Slope {
    std::int16_t x, y;  ///< 32767 being `mostSlope`
  };
  static constexpr float mostSlope = 8.0f;
  struct Level {
    glm::ivec2 size;
    std::size_t first;  ///< texel in `colours` and `slopes`
  };

  explicit TerrainSkin(const TerrainMap& map);

  const std::vector<Level>& levels() const { return levels_; }
  const std::vector<Colour>& colours() const { return colours_; }  ///< row by row from the south
  const std::vector<Slope>& slopes() const { return slopes_; }

  struct Texel {
    glm::vec3 reflectance{0.0f};
    glm::vec2 slope{0.0f};
  };
  /// Between texels and levels, at a place relative to the map's origin, m, for a pixel of
  /// `footprint` m.
  Texel at(glm::vec2 place, float footprint) const;
  /// Of the finest level, m.
  float texelSize() const { return texelSize_; }

  std::size_t memoryBytes() const {
    return colours_.capacity() * sizeof(Colour) + slopes_.capacity() * sizeof(Slope);
  }

 private:
  Texel atLevel(glm::vec2 part, std::size_t level) const;

  glm::vec2 extent_;
  float texelSize_;
  std::vector<Level> levels_;
  std::vector<Colour> colours_;
  std::vector<Slope> slopes_;
};

/// What a pixel of ground is shaded with; terrain.frag is its twin. `height` m above the still
/// water, `wetHeight` as high as water runs up.
struct GroundPixel {
  glm::vec3 normal, reflectance;
};
GroundPixel groundPixel(const TerrainSkin& skin, glm::vec2 place, float footprint, float height,
                        float wetHeight);

}  // namespace seaway::render
