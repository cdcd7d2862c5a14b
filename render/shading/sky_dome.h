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
  glm::vec3 side{0.0f}, arch{0.0f};  ///< of the twilight, times ½ + ½ cos azimuth, and its cube
  float asymmetry = 0.0f;            ///< g of the aerosol's phase function
};

/// Sunlight that reaches the sea on a plane that faces the sun; the disc sets over half a degree.
glm::vec3 sunIrradiance(glm::vec3 sunDirection);
HorizonLight horizonLight(glm::vec3 sunDirection);

/// Of the night's sky without a moon: far brighter than it is beside the sun's light, as the eye,
/// used to the dark, sees it.
inline constexpr glm::vec3 nightSky(0.25e-3f, 0.38e-3f, 0.65e-3f);

/// What lights the sky: unit vectors to sun and moon, and the moon's irradiance over the sun's.
struct SkyLights {
  glm::vec3 sun{0.0f, 0.0f, 1.0f}, moon{0.0f, 0.0f, 1.0f};
  float moonPart = 0.0f;
  friend bool operator==(const SkyLights&, const SkyLights&) = default;
};

/// The sky without the sun's disc, as a paraboloid map of the upper hemisphere with mip levels:
/// for the picture, for mirroring and for ambient light.
///
/// Clear maritime air, sunlight scattered once in a plane-parallel layer (closed form) with an
/// isotropic term for light scattered more often, and high clouds. As the sun sinks below 4° its
/// place is taken by a twilight (blue dome and warm arch, both ours) that fades to the night's sky
/// at −18°; moonlight is scattered as sunlight is. Texels are RGB9E5 (shared exponent), which
/// OpenGL reads as it is, so that both shade with the same sky.
class SkyDome {
 public:
  // Fine enough to be looked at: 4 mrad a texel at the horizon, where a pixel of a 60° camera with
  // 720 rows has 1.5 and the clouds have none finer than 10.
  static constexpr int side = 512, levels = 10;

  /// Draws the sky for lights whose directions are rounded to a thousandth of a radian, unless that
  /// is what it holds: a camera that moves over the globe does not redraw it.
  void drawFor(const SkyLights& lights);

  /// Counts drawings; 0 before the first.
  int version() const { return version_; }
  /// All levels, one after the other, the finest first; row by row.
  const std::vector<std::uint32_t>& texels() const { return texels_; }
  /// Mean radiance of the hemisphere.
  glm::vec3 mean() const { return mean_; }
  std::size_t memoryBytes() const { return texels_.capacity() * sizeof(std::uint32_t); }

 private:
  std::vector<std::uint32_t> texels_;
  SkyLights drawnFor_;
  glm::vec3 mean_{0.0f};
  int version_ = 0;
};

}  // namespace seaway::render
