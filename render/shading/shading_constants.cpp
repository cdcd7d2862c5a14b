#include "render/shading/shading_constants.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <iterator>

#include "render/band_limit.h"
#include "render/fresnel.h"
#include "render/render_technique.h"
#include "render/ripples.h"
#include "render/shading/night_constants.h"
#include "render/shading/shading_tables.h"
#include "render/shading/sky_dome.h"
#include "render/software/screen_triangle.h"
#include "surface/angles.h"
#include "surface/constants.h"
#include "surface/field/lattice_hash.h"
#include "surface/whitecaps.h"

namespace seaway::render {
namespace {

static_assert(ShadingConstants::rainCellSize == static_cast<float>(Rain::cell) &&
              ShadingConstants::rainLifetime == static_cast<float>(Rain::lifetime) &&
              ShadingConstants::rainSpeed == static_cast<float>(Rain::speed) &&
              ShadingConstants::rainWavelength == static_cast<float>(Rain::wavelength) &&
              ShadingConstants::rainHalfWidth == static_cast<float>(Rain::halfWidth) &&
              ShadingConstants::rainHeight == static_cast<float>(Rain::ringHeight));

constexpr float floatPi = static_cast<float>(pi);
constexpr glm::vec3 plainSky(1.2f);                              // where the sky is switched off
constexpr glm::vec3 deepReflectance(0.0050f, 0.0300f, 0.0520f);  // of light below the surface
// 1/m, of clear water: 5 % of red, green and blue are left after 4.5, 75 and 300 m (Toman).
constexpr glm::vec3 clearExtinction = 3.0f / glm::vec3(4.5f, 75.0f, 300.0f);
constexpr glm::vec3 crestTransmission(0.020f, 0.110f, 0.095f);
constexpr glm::vec3 foamReflectance(0.52f, 0.55f, 0.56f);  // of white water, not dense
constexpr glm::vec3 bubbleReflectance(0.010f, 0.055f, 0.062f);
constexpr glm::vec3 oilReflectance(0.010f, 0.008f, 0.006f);

void setCamera(ShadingConstants& c, const Camera& camera) {
  c.forward = glm::vec3(camera.forward());
  c.middleRay = glm::vec3(camera.middleRay());
  c.right = glm::vec3(camera.rightHalf());
  c.up = glm::vec3(camera.upperHalf());
  c.pixelAngle = static_cast<float>(camera.pixelAngle());
  const ScreenProjection projection(camera);
  c.pixelRight = projection.right;
  c.pixelDown = projection.down;
  c.pixelMiddle = projection.middle;
}

void setLight(ShadingConstants& c, const Lighting& lighting) {
  const glm::vec3 sun = lighting.sunDirection;
  c.sunIsOn = lighting.sunIsOn;
  c.skyIsOn = lighting.sky != nullptr;
  c.sunDirection = sun;
  c.levelSun = glm::vec2(sun);
  if (lighting.sunIsOn) c.sunLight = sunIrradiance(sun);
  c.skyLight = lighting.sky ? lighting.sky->mean() : plainSky;
  c.horizonOften = plainSky;
  if (lighting.sky) {
    const HorizonLight light = horizonLight(sun);
    c.horizonRayleigh = light.rayleigh;
    c.horizonAerosol = light.aerosol;
    c.horizonOften = light.often + nightSky;
    c.aerosolShape = {1.0f + light.asymmetry * light.asymmetry, 2.0f * light.asymmetry};
    c.horizonSide = light.side;
    c.horizonArch = light.arch;
    c.twilightIsOn = light.side.b > 0.0f;
  }
  if (lighting.moonPart > 0.0f) setMoon(c, lighting);
  c.hazeIsOn = lighting.hazeIsOn;
  // Exposed for the light that falls on the scene, as a hand-held meter would; at night the eye
  // does not follow all the way.
  const glm::vec3 light =
      c.skyLight + 0.25f * c.sunLight * std::max(c.sunDirection.z, 0.0f) / floatPi;
  const float luminance = glm::dot(light, glm::vec3(0.2126f, 0.7152f, 0.0722f));
  const float unfollowed = 0.03f * std::min(std::pow(luminance / 0.008f, 0.6f), 1.0f);
  c.exposure = 0.46f / (luminance + unfollowed + 1e-4f);
}

/// Mean density of haze between the sea and a height, m, of that at the sea: it falls to 1/e in
/// 1200 m (Preetham, Shirley & Smits 1999, 0.8333 km⁻¹).
double hazeBelow(double height) {
  const double depths = std::max(height, 0.0) / 1200.0;
  return depths > 1e-6 ? -std::expm1(-depths) / depths : 1.0;
}

void setTerms(ShadingConstants& c, const View& view) {
  const ShadingTerms& terms = view.light.terms;
  c.specular = static_cast<int>(terms.specular);
  c.extinctionIsLinear = terms.extinction == Extinction::linear;
  c.backFacesAreTilted = terms.backFaces == BackFaces::tilt;
  c.toneCurve = static_cast<int>(view.light.toneCurve);
  c.dithers = view.light.dithers;
  // At the visibility 2 % of the contrast are left (Koschmieder).
  const double atSea = -std::log(0.02) / view.light.visibility;
  c.airExtinction = static_cast<float>(atSea * hazeBelow(view.camera.position.z));
}

void setRipples(ShadingConstants& c, const View& view) {
  const Ripples ripples = ripplesFor(view.water->waves(), view.light.windSpeed);
  c.waveLean = glm::vec2(BandLimit(view.water->waves()).lean());
  c.ripplesAreOn = ripples.layerSlope > 0.0;
  const double slope =
      BandLimit(view.water->waves()).totalSlope() + 2.0 * ripples.layerSlope + ripples.hairSlope;
  c.seaDeviation = static_cast<float>(std::sqrt(0.5 * slope));
  c.sunlitFacets = litFacets(c.sunDirection.z, c.seaDeviation);
  c.rippleDeviation = static_cast<float>(std::sqrt(ripples.layerSlope));
  c.hairSlope = static_cast<float>(ripples.hairSlope);
  c.rippleLastLevel = ShadingTables::rippleLevels - 1.0f;
  std::copy(std::begin(shadingTables().rippleKept), std::end(shadingTables().rippleKept),
            c.rippleKept);
  for (int layer = 0; layer < 2; ++layer) {
    const glm::dmat2& matrix = ripples.textureFromWorld[layer];
    c.rippleFromWorld[2 * layer] = glm::vec2(matrix[0]);
    c.rippleFromWorld[2 * layer + 1] = glm::vec2(matrix[1]);
    c.rippleOrigin[layer] =
        glm::vec2(ripples.textureCoordinate(layer, glm::dvec2(view.camera.position), view.time));
    const double scale = glm::length(matrix[0]);
    c.rippleTexelsPerMetre[layer] = static_cast<float>(scale * ShadingTables::rippleSide);
    // World from patch is the matrix's transpose but for scale: its first column is the first row.
    c.rippleAlong[layer] = glm::vec2(glm::dvec2(matrix[0].x, matrix[1].x) / scale);
  }
}

/// ShadingConstants::sunThroughSurface for cosines from the vertical above and below: the flux
/// through a square metre of water is as wide as its cosine below.
float throughSurface(float above, float below) {
  const double cosine = std::max(above, 0.0f);
  const double let = 1.0 - fresnelReflectance(cosine, seaWaterIndex);
  return static_cast<float>(let * cosine / (below * seaWaterIndex * seaWaterIndex));
}

void setWater(ShadingConstants& c, const View& view) {
  const glm::vec3 onSea = c.skyLight + c.sunLight * std::max(c.sunDirection.z, 0.0f) / floatPi;
  c.waterExtinction = clearExtinction + static_cast<float>(view.light.turbidity);
  c.deepWater = deepReflectance * onSea;
  c.veil = 1.6f * c.deepWater;
  c.sunPartBelow = (onSea - c.skyLight) / glm::max(onSea, 1e-6f);
  c.eyeVeil = c.veil;
  if (!view.water) return;
  c.stillWater = static_cast<float>(-view.camera.position.z);
  c.eyeVeil = c.veil * glm::exp(-c.waterExtinction * std::max(c.stillWater, 0.0f));
  const glm::vec2 level = glm::vec2(c.sunDirection) / static_cast<float>(seaWaterIndex);
  c.sunInWater = {level, std::sqrt(1.0f - glm::dot(level, level))};
  c.sunThroughSurface = throughSurface(c.sunDirection.z, c.sunInWater.z);
  // An eye that is under water all the same gets used to what is left there, not all the way.
  const float depth = c.cameraIsUnderWater ? std::max(c.stillWater, 0.0f) : 0.0f;
  c.exposure *= 2.5f - 1.5f * std::exp(-0.5f * depth);
  c.bubbleLight = bubbleReflectance * onSea;
  c.oilLight = oilReflectance * onSea;
  const double crestHeight = 0.5 * view.water->waves().significantWaveHeight();
  c.crestScale = static_cast<float>(0.5 / std::max(crestHeight, 0.02));
  const glm::vec3 through = crestTransmission * static_cast<float>(std::min(crestHeight, 1.0));
  c.crestSky = through * 0.08f * c.skyLight;
  c.crestSun = through * 0.06f * c.sunLight;
}

/// Wakes higher than the sea's own crests are not what wind makes white: the rule is for waves of
/// a third of the highest wake's height then. They are white where they are steep.
float ofWindWaves(const WaterSurface& water, const WhitecapRule& rule) {
  const auto disturbances = water.disturbances();
  if (!disturbances) return 1.0f;
  const double wakes = rule.perHeight * disturbances->heightBound() / 3.0;
  return static_cast<float>(1.0 / std::max(wakes, 1.0));
}

void setFoam(ShadingConstants& c, const View& view) {
  c.foamIsOn = true;
  c.foamSky = foamReflectance * c.skyLight;
  c.foamSun = foamReflectance * c.sunLight / floatPi;
  const WaveField& waves = view.water->waves();
  const WhitecapRule rule(waves, view.light.windSpeed);
  const float wind = ofWindWaves(*view.water, rule);
  c.whitecapAlong = wind * glm::vec2(rule.toward * rule.perSlope);
  c.whitecapPerHeight = wind * static_cast<float>(rule.perHeight);
  c.whitecapMean = static_cast<float>(rule.mean);
  const double total = BandLimit(waves).totalSlope();
  c.perTotalSlope = total > 0.0 ? static_cast<float>(1.0 / total) : 0.0f;
  c.breakingRamp = {rule.breaking.threshold, rule.breaking.most / rule.breaking.width};
  c.oldRamp = {rule.old.threshold, 1.0 / rule.old.width, rule.old.most};
  c.foamLastLevel = FoamTable::levels - 1.0f;
  std::copy(std::begin(foamTable().kept), std::end(foamTable().kept), c.foamKept);
  // Sizes and angles without a common measure: the three repeat together nowhere in view. Foam is
  // carried along by the current.
  const double sides[3] = {61.0, 9.7, 2.37}, angles[3] = {0.85, 0.35, 1.93};
  const glm::dvec2 foot = glm::dvec2(view.camera.position) - waves.settings().current * view.time;
  for (int layer = 0; layer < 3; ++layer) {
    const glm::dvec2 axis = unitVector(angles[layer]) / sides[layer];
    c.foamAxis[layer] = glm::vec2(axis);
    c.foamOrigin[layer] = glm::vec2(glm::fract(
        glm::dvec2(axis.x * foot.x + axis.y * foot.y, axis.x * foot.y - axis.y * foot.x)));
    c.foamTexelsPerMetre[layer] = static_cast<float>(FoamTable::side / sides[layer]);
  }
}

void setRain(ShadingConstants& c, const View& view, const Rain& rain) {
  c.rainIsOn = true;
  const glm::dvec2 foot(view.camera.position);
  const glm::dvec2 cell = glm::floor(foot / Rain::cell);
  c.rainColumn = cellBits(cell.x);
  c.rainRow = cellBits(cell.y);
  c.rainFoot = glm::vec2(foot - cell * Rain::cell);
  const double turns = view.time / Rain::lifetime;
  c.rainCount = cellBits(std::floor(turns));
  c.rainPart = static_cast<float>(turns - std::floor(turns));
  c.rainSeed = rain.seed;
  c.rainDrops = static_cast<float>(rain.drops);
  c.rainSlots = static_cast<int>(std::ceil(rain.drops));
  c.rainMeanSquare = static_cast<float>(rain.meanSquareSlope());
}

}  // namespace

glm::vec3 sunDirectionOf(const View& view) {
  return skyDirection(view.light.sunElevation, view.light.sunDirection);
}

float litFacets(float height, float deviation) {
  if (height <= 0.0f) return 0.0f;
  return static_cast<float>(
      std::min(height / std::max(roughReflection(height, deviation).area, 1e-3), 1.0));
}

ShadingConstants shadingConstants(const View& view, const Lighting& lighting) {
  ShadingConstants c;
  c.cameraIsUnderWater = lighting.cameraIsUnderWater;
  setCamera(c, view.camera);
  setLight(c, lighting);
  setTerms(c, view);
  if (lighting.lampsAreOn) setLamps(c, view);
  setStars(c, lighting);
  setWater(c, view);
  if (lighting.waterIsOn) setRipples(c, view);
  if (lighting.foamIsOn) setFoam(c, view);
  if (lighting.rainIsOn) setRain(c, view, view.water->extras().events->rain());
  return c;
}

}  // namespace seaway::render
