#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace seaway::render {

struct View;
class SkyDome;

/// What shading needs that is the same for all pixels of a frame; the names are those that
/// sea_shading.glsl.h uses, and those of its uniforms in GLSL. Radiance in units in which the sun's
/// irradiance above the atmosphere is about 20.
struct ShadingConstants {
  // camera
  glm::vec3 forward{1.0f, 0.0f, 0.0f}, right{0.0f}, up{0.0f};  ///< right, up: half the image plane
  float pixelAngle = 0.0f;                                      ///< rad
  bool cameraIsUnderWater = false;
  // light
  bool sunIsOn = false, skyIsOn = false;
  glm::vec3 sunDirection{0.0f, 0.0f, 1.0f};
  glm::vec3 sunLight{0.0f};  ///< irradiance on a plane that faces the sun
  glm::vec3 skyLight{0.0f};  ///< mean radiance of the upper hemisphere
  float rootSunHeight = 0.0f;  ///< √ of the sun's sine of elevation
  glm::vec2 levelSun{0.0f};    ///< horizontal part of sunDirection
  glm::vec3 horizonRayleigh{0.0f}, horizonAerosol{0.0f}, horizonOften{0.0f};
  glm::vec2 aerosolShape{1.0f, 0.0f};  ///< 1 + g², 2g
  float airExtinction = 0.0f;          ///< 1/m
  float exposure = 1.0f;
  // water
  glm::vec3 waterExtinction{0.0f};  ///< 1/m
  glm::vec3 deepWater{0.0f};        ///< radiance that comes up from deep water
  glm::vec3 veil{0.0f};             ///< radiance of water itself, seen from inside
  glm::vec3 foamLight{0.0f};        ///< radiance of whitecaps, spread over the sea as crest⁴ is
  glm::vec3 crestSky{0.0f}, crestSun{0.0f};  ///< light through crests
  float crestScale = 0.0f;                   ///< 1/m
  bool ripplesAreOn = false;
  float rippleDeviation = 0.0f;   ///< of slope, of each layer
  float hairSlope = 0.0f;         ///< mean-square slope of what is finer than ripples
  float rippleLastLevel = 0.0f;   ///< mip level from which on nothing of a ripple is left
  glm::vec2 rippleFromWorld[4]{};  ///< columns of two matrices: texture coordinates from metres
  glm::vec2 rippleOrigin[2]{};     ///< texture coordinates of the camera's foot point
  glm::vec2 rippleAlong[2]{};      ///< unit vector of each patch's first axis
  float rippleTexelsPerMetre[2]{};
  float rippleKept[8]{};  ///< mean-square slope left in each mip level
};

/// What is lit in a frame.
struct Lighting {
  glm::vec3 sunDirection{0.0f, 0.0f, 1.0f};
  bool sunIsOn = false;
  const SkyDome* sky = nullptr;  ///< null: the sky is switched off, a plain grey stands for it
  bool waterIsOn = false;
  bool cameraIsUnderWater = false;
};

ShadingConstants shadingConstants(const View& view, const Lighting& lighting);

/// Unit vector from the camera to the sun.
glm::vec3 sunDirectionOf(const View& view);

}  // namespace seaway::render
