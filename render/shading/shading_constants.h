#pragma once

#include <cstdint>
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
  glm::vec3 forward{1.0f, 0.0f, 0.0f};
  /// Of the picture at 1 m: its middle, from there to its right and its upper edge.
  glm::vec3 middleRay{1.0f, 0.0f, 0.0f}, right{0.0f}, up{0.0f};
  float pixelAngle = 0.0f;                                      ///< rad
  /// Pixel of a place p from the camera, (0, 0) the top left one's centre: (dot(p, pixelRight),
  /// dot(p, pixelDown)) / dot(p, forward) + pixelMiddle.
  glm::vec3 pixelRight{0.0f}, pixelDown{0.0f};
  glm::vec2 pixelMiddle{0.0f};
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
  glm::vec3 crestSky{0.0f}, crestSun{0.0f};  ///< light through crests
  float crestScale = 0.0f;                   ///< 1/m
  // scene objects by way of the water (LocalLight)
  bool mirrorIsOn = false, belowIsOn = false;
  glm::vec2 mirrorLeast{0.0f}, mirrorSize{0.0f};  ///< box of pixels
  glm::vec2 belowLeast{0.0f}, belowSize{0.0f};
  static constexpr int mirrorSteps = 6;
  float mirrorNearest = 0.0f, mirrorFarthest = 0.0f;  ///< axial distances of what is mirrored, m
  bool ripplesAreOn = false;
  float rippleDeviation = 0.0f;   ///< of slope, of each layer
  float hairSlope = 0.0f;         ///< mean-square slope of what is finer than ripples
  float rippleLastLevel = 0.0f;   ///< mip level from which on nothing of a ripple is left
  glm::vec2 rippleFromWorld[4]{};  ///< columns of two matrices: texture coordinates from metres
  glm::vec2 rippleOrigin[2]{};     ///< texture coordinates of the camera's foot point
  glm::vec2 rippleAlong[2]{};      ///< unit vector of each patch's first axis
  float rippleTexelsPerMetre[2]{};
  float rippleKept[8]{};  ///< mean-square slope left in each mip level
  // foam (WhitecapRule) and oil
  bool foamIsOn = false;
  glm::vec3 foamSky{0.0f}, foamSun{0.0f};  ///< light of foam under the sky, facing the sun
  glm::vec3 bubbleLight{0.0f};             ///< of bubbles under it
  glm::vec3 oilLight{0.0f};                ///< that comes up through oil
  glm::vec2 whitecapAlong{0.0f};           ///< direction of the waves over σ of slope
  float whitecapPerHeight = 0.0f, whitecapMean = 0.0f;
  float perTotalSlope = 0.0f;        ///< 1 / mean-square slope of the field
  glm::vec2 breakingRamp{9e9f, 1.0f};  ///< threshold, 1/width
  glm::vec3 oldRamp{9e9f, 1.0f, 0.0f};  ///< threshold, 1/width, most
  glm::vec2 foamAxis[3]{}, foamOrigin[3]{};  ///< pattern from metres: first axis; the foot's place
  float foamTexelsPerMetre[3]{};
  float foamLastLevel = 0.0f;  ///< mip level from which on nothing of the pattern is left
  float foamKept[8]{};         ///< part of the pattern's variance that is left in each
  // rain (Rain)
  bool rainIsOn = false;
  std::uint32_t rainColumn = 0, rainRow = 0;  ///< cell that the camera's foot is in
  std::uint32_t rainCount = 0, rainSeed = 0;
  glm::vec2 rainFoot{0.0f};  ///< the foot from its cell's corner, m
  float rainPart = 0.0f, rainDrops = 0.0f, rainMeanSquare = 0.0f;
  int rainSlots = 0;
  static constexpr float rainCellSize = 0.6f, rainLifetime = 0.9f, rainSpeed = 0.25f;
  static constexpr float rainWavelength = 0.055f, rainHalfWidth = 0.07f, rainHeight = 0.003f;
};

/// What is lit in a frame.
struct Lighting {
  bool foamIsOn = false, rainIsOn = false;
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
