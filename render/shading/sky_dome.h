#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace seaway::render {

/// Sky radiance at the horizon apart from the direction's own terms: see horizonSky in
/// sea_shading.glsl.h.
struct HorizonLight {
  glm::vec3 rayleigh{0.0f}, aerosol{0.0f}, often{0.0f};
  float asymmetry = 0.0f;  ///< g of the aerosol's phase function
};

/// Sunlight that reaches the sea on a plane that faces the sun; the disc sets over half a degree.
glm::vec3 sunIrradiance(glm::vec3 sunDirection);
HorizonLight horizonLight(glm::vec3 sunDirection);

/// The sky without the sun's disc, as a paraboloid map of the upper hemisphere with mip levels:
/// for the picture, for mirroring and for ambient light.
///
/// Clear maritime air, sunlight scattered once in a plane-parallel layer (closed form) with an
/// isotropic term for light scattered more often, and high clouds. Texels are RGB9E5 (shared
/// exponent), which OpenGL reads as it is, so that both shade with the same sky.
class SkyDome {
 public:
  // Fine enough to be looked at: 4 mrad a texel at the horizon, where a pixel of a 60° camera with
  // 720 rows has 1.5 and the clouds have none finer than 10.
  static constexpr int side = 512, levels = 10;

  /// Draws the sky for a sun whose direction is rounded to a thousandth of a radian, unless that is
  /// what it holds: a camera that moves over the globe does not redraw it.
  void drawFor(glm::vec3 sunDirection);

  /// Counts drawings; 0 before the first.
  int version() const { return version_; }
  /// All levels, one after the other, the finest first; row by row.
  const std::vector<std::uint32_t>& texels() const { return texels_; }
  /// Mean radiance of the hemisphere.
  glm::vec3 mean() const { return mean_; }
  std::size_t memoryBytes() const { return texels_.capacity() * sizeof(std::uint32_t); }

 private:
  std::vector<std::uint32_t> texels_;
  glm::vec3 drawnFor_{0.0f}, mean_{0.0f};
  int version_ = 0;
};

}  // namespace seaway::render
