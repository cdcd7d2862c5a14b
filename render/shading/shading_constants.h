#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace seaway::render {

struct Lamp;
struct Moon;
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
  float pixelAngle = 0.0f;  ///< rad
  /// Pixel of a place p from the camera, (0, 0) the top left one's centre: (dot(p, pixelRight),
  /// dot(p, pixelDown)) / dot(p, forward) + pixelMiddle.
  glm::vec3 pixelRight{0.0f}, pixelDown{0.0f};
  glm::vec2 pixelMiddle{0.0f};
  bool cameraIsUnderWater = false;
  // light
  bool sunIsOn = false, skyIsOn = false;
  glm::vec3 sunDirection{0.0f, 0.0f, 1.0f};
  glm::vec3 sunLight{0.0f};   ///< irradiance on a plane that faces the sun
  glm::vec3 skyLight{0.0f};   ///< mean radiance of the upper hemisphere
  float seaDeviation = 0.0f;  ///< of all the sea's slopes along an axis, whatever carries them
  float sunlitFacets = 1.0f;  ///< part of them that no wave hides from the sun
  glm::vec2 levelSun{0.0f};   ///< horizontal part of sunDirection
  glm::vec3 horizonRayleigh{0.0f}, horizonAerosol{0.0f}, horizonOften{0.0f};
  glm::vec2 aerosolShape{1.0f, 0.0f};  ///< 1 + g², 2g
  bool hazeIsOn = false;
  float airExtinction = 0.0f;  ///< 1/m
  float exposure = 1.0f;
  int toneCurve = 0;  ///< ToneCurve
  bool dithers = false;
  // dusk and night: by night the moon's light stands in sunDirection and sunLight
  bool twilightIsOn = false;
  glm::vec3 horizonSide{0.0f}, horizonArch{0.0f};  ///< of the twilight, by azimuth from the sun
  bool moonIsOn = false;
  glm::vec2 levelMoon{0.0f};                        ///< horizontal part of the moon's direction
  glm::vec3 moonRayleigh{0.0f}, moonAerosol{0.0f};  ///< as horizonRayleigh, horizonAerosol
  glm::vec3 discAxis{0.0f};  ///< across the moon's disc to its lit limb, unit
  float discEdge = -1.0f;    ///< terminator: −1 full, 1 new
  float discLight = 6.0f;    ///< radiance of the sun's or the moon's disc over its irradiance
  float starLight = 0.0f;    ///< irradiance by a star of magnitude 0; 0: none are seen
  static constexpr int mostLamps = 16;
  int lampCount = 0;
  glm::vec3 lampPlace[mostLamps]{};  ///< from the camera, m
  glm::vec3 lampLight[mostLamps]{};  ///< radiant intensity
  float lampWidth[mostLamps]{};      ///< variance of its picture's angle, rad²
  float lampShines[mostLamps]{};     ///< 1: on things too; 0: not
  // rival terms
  int specular = 0;  ///< Specular
  bool extinctionIsLinear = false, backFacesAreTilted = true;
  // water
  glm::vec3 waterExtinction{0.0f};           ///< 1/m
  glm::vec3 deepWater{0.0f};                 ///< radiance that comes up from deep water
  glm::vec3 veil{0.0f};                      ///< radiance of water itself, seen from inside
  glm::vec3 crestSky{0.0f}, crestSun{0.0f};  ///< light through crests
  float crestScale = 0.0f;                   ///< 1/m
  // scene objects by way of the water (LocalLight)
  bool mirrorIsOn = false, belowIsOn = false;
  glm::vec2 mirrorLeast{0.0f}, mirrorSize{0.0f};  ///< box of pixels
  glm::vec2 belowLeast{0.0f}, belowSize{0.0f};
  int mirrorSteps = 6;
  float mirrorBend = 0.0f;     ///< 0: steps through those distances are even; 1: they grow
  float shoreHardness = 0.0f;  ///< 1/m: how fast water fades in over a bed; 0: it does not
  float mirrorNearest = 0.0f, mirrorFarthest = 0.0f;  ///< axial distances of what is mirrored, m
  // the same from under water
  bool windowIsOn = false, depthsAreOn = false;
  glm::vec2 windowLeast{0.0f}, windowSize{0.0f};
  glm::vec2 depthsLeast{0.0f}, depthsSize{0.0f};
  float stillWater = -1e30f;               ///< height of still water from the eye, m
  glm::vec3 sunInWater{0.0f, 0.0f, 1.0f};  ///< sunDirection refracted at still water
  /// Irradiance just below still water, facing the refracted sun, over that above it facing the
  /// sun, over the square of water's index: radiance grows by as much on its way in.
  float sunThroughSurface = 0.5f;
  glm::vec3 eyeVeil{0.0f};  ///< veil as deep as the eye is
  // which pixels are under water (Waterline)
  bool waterlineIsOn = false;  ///< else all as cameraIsUnderWater says
  glm::vec2 waterlinePerPixel{0.0f};
  static constexpr int waterlineCells = 64;
  // shadows (ShadowMaps); lengths in m, places in texels
  static constexpr int mostShadowMaps = 3;
  int shadowCount = 0;
  glm::vec3 shadowRight{0.0f}, shadowUp{0.0f};
  glm::vec3 shadowBend{0.0f};  ///< what a metre of depth moves a place by
  float shadowBase = 0.0f;
  glm::vec2 shadowLeast[mostShadowMaps]{}, shadowSize[mostShadowMaps]{};
  float shadowTexel[mostShadowMaps]{}, shadowRow[mostShadowMaps]{};
  glm::vec3 sunPartBelow{0.0f};  ///< part of deepWater that is the sun's
  /// Of the waves' slopes, over their mean square: (mean square along x less that along y, twice
  /// their mean product); a length of 1 is waves of one direction, 0 of all alike.
  glm::vec2 waveLean{0.0f};
  bool ripplesAreOn = false;
  float rippleDeviation = 0.0f;    ///< of slope, of each layer
  float hairSlope = 0.0f;          ///< mean-square slope of what is finer than ripples
  float rippleLastLevel = 0.0f;    ///< mip level from which on nothing of a ripple is left
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
  float perTotalSlope = 0.0f;                ///< 1 / mean-square slope of the field
  glm::vec2 breakingRamp{9e9f, 1.0f};        ///< threshold, 1/width
  glm::vec3 oldRamp{9e9f, 1.0f, 0.0f};       ///< threshold, 1/width, most
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
  bool hazeIsOn = false;
  glm::vec3 moonDirection{0.0f, 0.0f, 1.0f};
  float moonEdge = -1.0f;  ///< ShadingConstants::discEdge
  float moonPart = 0.0f;   ///< its irradiance over the sun's; 0: no moon lights the scene
  bool lampsAreOn = false;
};

ShadingConstants shadingConstants(const View& view, const Lighting& lighting);

/// Part of a sea's facets that no wave hides from a light at that sine of elevation (Smith's
/// shadowing: what is lit, over the facets' area projected towards the light), for slopes of that
/// deviation along an axis.
float litFacets(float height, float deviation);

/// Unit vector from the camera to the sun.
glm::vec3 sunDirectionOf(const View& view);
/// Likewise to a moon.
glm::vec3 directionOf(const Moon& moon);

/// Part of a lamp's light that a viewer at `eye` sees, [0, 1]: all within its arc, falling to none
/// over the 3° beyond its edges that the collision regulations allow (COLREG, Annex I, 9), and from
/// 25° to 40° above and below its plane. Lamps with an arc all round shine up and down too.
double shownPart(const Lamp& lamp, glm::dvec3 eye);

}  // namespace seaway::render
