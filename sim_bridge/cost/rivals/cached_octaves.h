#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "sim_bridge/cost/rivals/texel_kernels.h"
#include "surface/field/octave.h"

namespace seaway::rivals {

/// The seed's way to buy speed with accuracy (Johanson 2004; TECHNIQUES, "Demo settings"): eight
/// Perlin octaves in two tiled textures of 256² texels, four octaves each on 32² … 256² lattice
/// cells, with mipmaps. A texture drifts as a whole along x at the speed of its second octave; its
/// octaves boil in place. The noise is PerlinOctave's, repeated after one texture.
class CachedOctaves {
 public:
  static constexpr std::uint32_t texels = 256, octavesPerTexture = 4, baseCells = 32;

  /// Eight Perlin octaves, each lattice half as large as the one before.
  explicit CachedOctaves(std::span<const Octave> octaves);

  /// Fills both textures and their mipmaps for one time.
  void step(double t);

  /// `detail` is the mipmap level: 0 is the finest; between two levels both are looked up.
  void sample(std::span<const double> x, std::span<const double> y, Interpolation interpolation,
              double detail, std::span<Texel> out) const;

  /// Sum of the octaves themselves in double: the truth.
  std::vector<double> exactHeights(std::span<const glm::dvec2> points, double t) const;

  /// Where texel (i, j) of a texture lies at the time of the last step, m.
  glm::dvec2 texelCentre(std::size_t texture, std::uint32_t i, std::uint32_t j) const;
  const Texel& texel(std::size_t texture, std::uint32_t i, std::uint32_t j) const {
    return textures_[texture].levels[0][j * texels + i];
  }
  /// Share of one texture in `exactHeights`.
  std::vector<double> exactHeights(std::size_t texture, std::span<const glm::dvec2> points,
                                   double t) const;

  std::size_t memoryBytes() const;

 private:
  struct Texture {
    double texelSize = 0.0;   // m
    double driftSpeed = 0.0;  // m/s along x
    double drift = 0.0;       // m since t = 0
    std::array<Octave, octavesPerTexture> octaves;
    std::vector<std::vector<Texel>> levels;
  };
  void fill(Texture& texture, std::size_t first, double t) const;

  std::array<Texture, 2> textures_;
};

}  // namespace seaway::rivals
