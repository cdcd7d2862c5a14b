#include "render/shading/shading_constants.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <iterator>

#include "render/render_technique.h"
#include "render/ripples.h"
#include "render/shading/shading_tables.h"
#include "render/shading/sky_dome.h"
#include "surface/constants.h"

namespace seaway::render {
namespace {

constexpr float floatPi = static_cast<float>(pi);
constexpr glm::vec3 plainSky(1.2f);  // where the sky is switched off
constexpr glm::vec3 deepReflectance(0.0050f, 0.0300f, 0.0520f);  // of light below the surface
constexpr glm::vec3 waterExtinction(0.40f, 0.075f, 0.055f);      // 1/m
constexpr glm::vec3 crestTransmission(0.020f, 0.110f, 0.095f);
constexpr double visibility = 28e3;  // m, at 2 % contrast

void setCamera(ShadingConstants& c, const Camera& camera) {
  const double halfHeight = std::tan(0.5 * camera.verticalFieldOfView);
  c.forward = glm::vec3(camera.forward());
  c.right = glm::vec3(-camera.left() * (halfHeight * camera.aspectRatio()));
  c.up = glm::vec3(camera.up() * halfHeight);
  c.pixelAngle = static_cast<float>(2.0 * halfHeight / camera.size.y);
}

void setLight(ShadingConstants& c, const Lighting& lighting) {
  const glm::vec3 sun = lighting.sunDirection;
  c.sunIsOn = lighting.sunIsOn;
  c.skyIsOn = lighting.sky != nullptr;
  c.sunDirection = sun;
  c.levelSun = glm::vec2(sun);
  c.rootSunHeight = std::sqrt(std::max(sun.z, 0.0f));
  if (lighting.sunIsOn) c.sunLight = sunIrradiance(sun);
  c.skyLight = lighting.sky ? lighting.sky->mean() : plainSky;
  c.horizonOften = plainSky;
  if (lighting.sky) {
    const HorizonLight light = horizonLight(sun);
    c.horizonRayleigh = light.rayleigh;
    c.horizonAerosol = light.aerosol;
    c.horizonOften = light.often;
    c.aerosolShape = {1.0f + light.asymmetry * light.asymmetry, 2.0f * light.asymmetry};
  }
  c.airExtinction = static_cast<float>(-std::log(0.02) / visibility);
  // Exposed for the light that falls on the scene, as a hand-held meter would; at night the eye
  // does not follow all the way.
  const glm::vec3 light = c.skyLight + 0.25f * c.sunLight * std::max(sun.z, 0.0f) / floatPi;
  c.exposure = 0.46f / (glm::dot(light, glm::vec3(0.2126f, 0.7152f, 0.0722f)) + 0.02f);
}

void setRipples(ShadingConstants& c, const View& view) {
  const Ripples ripples = ripplesFor(view.water->waves(), view.light.windSpeed);
  c.ripplesAreOn = ripples.layerSlope > 0.0;
  c.rippleDeviation = static_cast<float>(std::sqrt(ripples.layerSlope));
  c.hairSlope = static_cast<float>(ripples.hairSlope);
  c.rippleLastLevel = ShadingTables::rippleLevels - 1.0f;
  std::copy(std::begin(shadingTables().rippleKept), std::end(shadingTables().rippleKept),
            c.rippleKept);
  for (int layer = 0; layer < 2; ++layer) {
    const glm::dmat2& matrix = ripples.textureFromWorld[layer];
    c.rippleFromWorld[2 * layer] = glm::vec2(matrix[0]);
    c.rippleFromWorld[2 * layer + 1] = glm::vec2(matrix[1]);
    c.rippleOrigin[layer] = glm::vec2(
        ripples.textureCoordinate(layer, glm::dvec2(view.camera.position), view.time));
    const double scale = glm::length(matrix[0]);
    c.rippleTexelsPerMetre[layer] = static_cast<float>(scale * ShadingTables::rippleSide);
    // World from patch is the matrix's transpose but for scale: its first column is the first row.
    c.rippleAlong[layer] = glm::vec2(glm::dvec2(matrix[0].x, matrix[1].x) / scale);
  }
}

void setWater(ShadingConstants& c, const View& view) {
  const glm::vec3 onSea = c.skyLight + c.sunLight * std::max(c.sunDirection.z, 0.0f) / floatPi;
  c.waterExtinction = waterExtinction;
  c.deepWater = deepReflectance * onSea;
  c.veil = 1.6f * c.deepWater;
  if (!view.water) return;
  // Cover by Monahan & O'Muircheartaigh 1980, reflectance by Koepke 1984, redder light lost in the
  // bubbles' water; crest⁴ of the shading has a mean of 0.168 where heights are Gaussian.
  const double cover = std::min(3.84e-6 * std::pow(view.light.windSpeed, 3.41), 1.0);
  c.foamLight = static_cast<float>(0.22 / 0.168 * cover) * glm::vec3(0.6f, 0.9f, 1.0f) * onSea;
  const double crestHeight = 0.5 * view.water->waves().significantWaveHeight();
  c.crestScale = static_cast<float>(0.5 / std::max(crestHeight, 0.02));
  const glm::vec3 through = crestTransmission * static_cast<float>(std::min(crestHeight, 1.0));
  c.crestSky = through * 0.08f * c.skyLight;
  c.crestSun = through * 0.06f * c.sunLight;
}

}  // namespace

glm::vec3 sunDirectionOf(const View& view) {
  const Light& light = view.light;
  return glm::vec3(glm::dvec3(std::cos(light.sunElevation) * std::cos(light.sunDirection),
                              std::cos(light.sunElevation) * std::sin(light.sunDirection),
                              std::sin(light.sunElevation)));
}

ShadingConstants shadingConstants(const View& view, const Lighting& lighting) {
  ShadingConstants c;
  c.cameraIsUnderWater = lighting.cameraIsUnderWater;
  setCamera(c, view.camera);
  setLight(c, lighting);
  setWater(c, view);
  if (lighting.waterIsOn) setRipples(c, view);
  return c;
}

}  // namespace seaway::render
