#pragma once

#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/gtc/packing.hpp>
#include <vector>

#include "render/shading/pixel_shader.h"
#include "render/shading/sky_dome.h"
#include "surface/angles.h"

/// The water's shading by itself, on made constants.
namespace seaway::render::test {

/// Texels of a sky of one radiance.
inline std::vector<std::uint32_t> evenSky(float radiance) {
  std::size_t texels = 0;
  for (int side = SkyDome::side; side >= 1; side /= 2) texels += std::size_t(side) * side;
  return std::vector<std::uint32_t>(texels, glm::packF3x9_E1x5(glm::vec3(radiance)));
}

/// Radiance 1 everywhere, in a box of pixels.
inline LocalImage whiteImage(glm::ivec2 least, glm::ivec2 size, float nearness) {
  LocalImage image;
  image.least = least;
  image.size = size;
  image.resize();
  // 1 = 256 · 2^(16 − 24), three times.
  for (std::uint32_t& word : image.light) word = 16u << 27 | 256u << 18 | 256u << 9 | 256u;
  for (float& n : image.nearness) n = nearness;
  return image;
}

/// A piece of water 10 m away, seen at an angle from the vertical.
struct LitWater {
  ShadingConstants constants;
  std::vector<std::uint32_t> sky = evenSky(1.0f);
  LocalImage mirrored, below;
  glm::vec2 slope{0.0f};
  float roughness = 0.0f;  ///< mean-square slope that the pixel cannot show

  LitWater() {
    constants.skyIsOn = true;
    constants.pixelAngle = 1e-3f;
  }

  PixelSpan span(double fromVertical_deg, ShadedAs kind = ShadedAs::water) const {
    PixelSpan made;
    const double angle = radiansFromDegrees(fromVertical_deg);
    made.firstRay = glm::vec3(glm::dvec3(std::sin(angle), 0.0, -std::cos(angle)));
    if (kind == ShadedAs::underside) made.firstRay.z = -made.firstRay.z;
    made.count = 1;
    for (int i = 0; i < 16; ++i) {
      made.kind[i] = kind;
      made.axial[i] = 10.0f;
      made.slopeX[i] = slope.x;
      made.slopeY[i] = slope.y;
      made.missingSlope[i] = roughness;
      made.height[i] = 0.0f;
    }
    return made;
  }
  glm::vec3 radiance(double fromVertical_deg, ShadedAs kind = ShadedAs::water) const {
    ShadingConstants c = constants;
    const PixelSpan pixels = span(fromVertical_deg, kind);
    c.forward = pixels.firstRay;
    glm::vec4 light[16];
    shadeSpan(ShadingSources{c, sky.data(), &mirrored, &below}, pixels, light);
    return glm::vec3(light[0]);
  }
};

}  // namespace seaway::render::test
