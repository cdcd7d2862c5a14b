#include "render/shading/night_constants.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <vector>

#include "render/render_technique.h"
#include "render/shading/sky_dome.h"
#include "surface/angles.h"
#include "surface/constants.h"
#include "surface/curvature.h"

namespace seaway::render {
namespace {

constexpr double nightGain = 1000.0;
/// The sun's 20 units of irradiance are about 130 000 lux.
constexpr double perLux = 20.0 / 130e3;
constexpr double fullMoonOverSun = 0.25 / 130e3;
constexpr double starOfMagnitudeZero = 2.5e-6;  // lux

}  // namespace

glm::vec3 skyDirection(double elevation, double direction) {
  return glm::vec3(glm::dvec3(std::cos(elevation) * std::cos(direction),
                              std::cos(elevation) * std::sin(direction), std::sin(elevation)));
}

glm::vec3 directionOf(const Moon& moon) { return skyDirection(moon.elevation, moon.direction); }

float moonPart(const Moon& moon, glm::vec3 sunDirection) {
  const double angle = 360.0 * std::abs(moon.phase - 0.5);           // Sun–Moon–Earth, degrees
  const double fainter = 0.026 * angle + 4e-9 * std::pow(angle, 4);  // magnitudes
  const double dark = glm::smoothstep(-0.01, -0.12, static_cast<double>(sunDirection.z));
  return static_cast<float>(nightGain * fullMoonOverSun * std::pow(10.0, -0.4 * fainter) * dark);
}

void setMoon(ShadingConstants& c, const Lighting& lighting) {
  const glm::vec3 moon = lighting.moonDirection;
  c.moonIsOn = c.sunIsOn = true;
  c.sunDirection = moon;
  c.sunLight = lighting.moonPart * sunIrradiance(moon);
  c.levelMoon = glm::vec2(moon);
  if (lighting.sky) {
    const HorizonLight light = horizonLight(moon);
    c.moonRayleigh = lighting.moonPart * light.rayleigh;
    c.moonAerosol = lighting.moonPart * light.aerosol;
    c.horizonOften += lighting.moonPart * light.often;
  }
  // The lit limb looks to where the sun is.
  const glm::vec3 across = lighting.sunDirection - moon * glm::dot(moon, lighting.sunDirection);
  const float length = glm::length(across);
  c.discAxis = length > 1e-3f ? across / length : glm::vec3(0.0f);
  c.discEdge = lighting.moonEdge;
  // What a full moon's whole disc sends comes from the lit part of another's.
  c.discLight /= std::max(0.5f * (1.0f - c.discEdge), 0.01f);
}

double shownPart(const Lamp& lamp, glm::dvec3 eye) {
  if (lamp.arc >= 2.0 * pi) return 1.0;
  const glm::dvec3 offset = eye - lamp.position;
  const glm::dvec3 level = offset - lamp.up * glm::dot(lamp.up, offset);
  const double away = glm::length(level);
  if (away < 1e-9) return 0.0;
  const double angle = std::acos(std::clamp(glm::dot(level, lamp.towards) / away, -1.0, 1.0));
  const double rise = std::atan2(std::abs(glm::dot(lamp.up, offset)), away);
  return std::clamp((0.5 * lamp.arc - angle) / radiansFromDegrees(3.0) + 1.0, 0.0, 1.0) *
         std::clamp((radiansFromDegrees(40.0) - rise) / radiansFromDegrees(15.0), 0.0, 1.0);
}

void setLamps(ShadingConstants& c, const View& view) {
  struct Seen {
    const Lamp* lamp;
    glm::dvec3 place;
    double intensity, distance;
    double brightness() const { return intensity / (distance * distance); }
  };
  std::vector<Seen> seen;
  for (const Lamp& lamp : view.lamps) {
    const double intensity = lamp.candela * shownPart(lamp, view.camera.position);
    glm::dvec3 place = lamp.position - view.camera.position;
    place.z -= seaDrop(glm::length(glm::dvec2(place)));
    const double distance = std::max(glm::length(place), 0.01);
    if (intensity > 0.0) seen.push_back({&lamp, place, intensity, distance});
  }
  std::stable_sort(seen.begin(), seen.end(),
                   [](const Seen& a, const Seen& b) { return a.brightness() > b.brightness(); });
  c.lampCount = static_cast<int>(std::min<std::size_t>(seen.size(), ShadingConstants::mostLamps));
  for (int i = 0; i < c.lampCount; ++i) {
    const Seen& lamp = seen[i];
    const glm::vec3 colour = lamp.lamp->colour;
    const float luminance = std::max(glm::dot(colour, glm::vec3(0.2126f, 0.7152f, 0.0722f)), 1e-3f);
    c.lampPlace[i] = glm::vec3(lamp.place);
    c.lampLight[i] = colour * static_cast<float>(nightGain * perLux * lamp.intensity / luminance);
    const double size = 0.06 / lamp.distance;  // a lantern's radius, m
    c.lampWidth[i] =
        0.4f * c.pixelAngle * c.pixelAngle + static_cast<float>(0.25 * size * size) + 1e-9f;
    c.lampShines[i] = lamp.lamp->shines ? 1.0f : 0.0f;
  }
}

void setStars(ShadingConstants& c, const Lighting& lighting) {
  const float dark = glm::smoothstep(-0.12f, -0.24f, lighting.sunDirection.z);
  if (lighting.sky)
    c.starLight = dark * static_cast<float>(nightGain * perLux * starOfMagnitudeZero);
}

}  // namespace seaway::render
