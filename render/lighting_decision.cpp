#include "render/lighting_decision.h"

#include <algorithm>
#include <cmath>

#include "render/scene_object.h"
#include "render/shading/night_constants.h"
#include "render/shading/shading_tables.h"
#include "render/surf.h"
#include "surface/constants.h"
#include "surface/whitecaps.h"

namespace seaway::render {
namespace {

/// Less white water than this is not looked for: a metre in a hundred by a hundred.
constexpr double leastWhitecaps = 1e-4;

/// Whether any ray of the picture goes above the horizontal: if one does, one at a corner does.
bool seesAboveHorizon(const Camera& camera) {
  const glm::dvec2 last = glm::dvec2(camera.size) - 0.5;
  for (const glm::dvec2 pixel :
       {glm::dvec2(-0.5, -0.5), glm::dvec2(last.x, -0.5), glm::dvec2(-0.5, last.y), last}) {
    if (camera.rayThrough(pixel).z > 0.0) return true;
  }
  return false;
}

bool decideFoam(const View& view, const Shown& shown) {
  const char* reason = "no water in the picture";
  bool called = false;
  if (shown.water && shown.cameraIsUnderWater) reason = "the camera is under water";
  if (shown.water && !shown.cameraIsUnderWater) {
    const auto& detail = view.water->extras().detail;
    const bool lies = detail && detail->cover.foam;
    const bool blows =
        WhitecapRule(view.water->waves(), view.light.windSpeed).mean >= leastWhitecaps;
    const bool wakes = view.water->disturbances() != nullptr;
    const bool breaks = shown.terrain && surfOf(view).has_value();
    called = lies || blows || wakes || breaks;
    reason = blows    ? "the wind raises whitecaps"
             : lies   ? "foam lies on the water"
             : wakes  ? "a wake may break"
             : breaks ? "waves break on a shore"
                      : "no wind, no wake, no foam";
  }
  return view.effects->decide(Effect::foam, called, reason) && shown.water;
}

bool decideRain(const View& view, const Shown& shown) {
  const bool falls = view.water && view.water->extras().events &&
                     view.water->extras().events->rain().falls(view.time);
  const bool called = falls && shown.water && !shown.cameraIsUnderWater;
  return view.effects->decide(Effect::rain, called,
                              called  ? "it rains on water in view"
                              : falls ? "no water in the picture"
                                      : "no rain") &&
         called;
}

bool decideHaze(const View& view, const Shown& shown) {
  const bool called = (shown.water || shown.objects) && !shown.cameraIsUnderWater;
  return view.effects->decide(Effect::haze, called,
                              called                     ? "air dims what is far"
                              : shown.cameraIsUnderWater ? "the camera is under water"
                                                         : "nothing but sky is in view") &&
         called;
}

/// Whether the moon stands in for a sun that is below the horizon.
bool decideMoon(const View& view, bool sunIsUp, bool isSeen) {
  const auto& moon = view.light.moon;
  const bool isUp = moon && directionOf(*moon).z > -0.01f;
  const bool called = isUp && !sunIsUp && isSeen;
  return view.effects->decide(Effect::moon, called,
                              called    ? "the moon is up and the sun is not"
                              : !moon   ? "the scene has no moon"
                              : sunIsUp ? "the sun is up"
                              : !isUp   ? "the moon is below the horizon"
                                        : "nothing that it lights is in view") &&
         called;
}

/// Navigation lights are shown from sunset to sunrise (COLREG, Rule 20b).
bool decideLamps(const View& view, glm::vec3 sunDirection, bool isUnderWater) {
  const bool any = std::any_of(view.lamps.begin(), view.lamps.end(), [&](const Lamp& lamp) {
    return shownPart(lamp, view.camera.position) > 0.0;
  });
  const bool isDark = sunDirection.z < 0.0f;
  const bool called = any && isDark && !isUnderWater;
  return view.effects->decide(Effect::lights, called,
                              called               ? "a lamp shows and the sun has set"
                              : !isDark            ? "the sun is up"
                              : view.lamps.empty() ? "the scene has no lamps"
                              : isUnderWater       ? "the camera is under water"
                                                   : "no lamp's arc shows towards the camera") &&
         any && !isUnderWater;
}

}  // namespace

Lighting decideLighting(const View& view, const Shown& shown, std::optional<SkyDome>& sky) {
  Lighting lighting;
  lighting.waterIsOn = shown.water;
  lighting.cameraIsUnderWater = shown.cameraIsUnderWater;
  lighting.sunDirection = sunDirectionOf(view);
  lighting.foamIsOn = decideFoam(view, shown);
  lighting.rainIsOn = decideRain(view, shown);
  if (lighting.foamIsOn) {
    view.effects->chargeInside(Effect::foam, Effect::water);
    view.effects->holdMemory(Effect::foam, foamTable().texels.size() * sizeof(float));
  }
  if (lighting.rainIsOn) view.effects->chargeInside(Effect::rain, Effect::water);
  const bool sunIsUp = lighting.sunDirection.z > -0.01f;  // its disc is half a degree wide
  const bool skyIsSeen = shown.water || seesAboveHorizon(view.camera);
  const bool sunIsSeen = sunIsUp && (skyIsSeen || shown.objects || shown.terrain);
  lighting.sunIsOn = view.effects->decide(Effect::sun, sunIsSeen,
                                          sunIsSeen ? "the sun is up"
                                          : sunIsUp ? "nothing that it lights is in view"
                                                    : "the sun is below the horizon");
  lighting.hazeIsOn = decideHaze(view, shown);
  if (decideMoon(view, sunIsUp, skyIsSeen || shown.objects)) {
    lighting.moonDirection = directionOf(*view.light.moon);
    lighting.moonPart = moonPart(*view.light.moon, lighting.sunDirection);
    lighting.moonEdge = static_cast<float>(std::cos(2.0 * pi * view.light.moon->phase));
  }
  lighting.lampsAreOn = decideLamps(view, lighting.sunDirection, shown.cameraIsUnderWater);
  const std::optional<Effect> payer = shown.water ? std::optional(Effect::water)
                                      : skyIsSeen ? std::optional(Effect::sky)
                                                  : std::nullopt;
  if (payer) {
    if (lighting.hazeIsOn) view.effects->chargeInside(Effect::haze, *payer);
    if (lighting.moonPart > 0.0f) view.effects->chargeInside(Effect::moon, *payer);
    if (lighting.lampsAreOn) view.effects->chargeInside(Effect::lights, *payer);
  }
  const bool skyLights = shown.objects || shown.terrain;
  const char* reason = shown.water ? "water reflects it"
                       : skyIsSeen ? "the camera sees above the horizon"
                       : skyLights ? "it lights what is in view"
                                   : "nothing shows it, reflects it or is lit by it";
  if (view.effects->decide(Effect::sky, skyIsSeen || skyLights, reason)) {
    if (!sky) sky.emplace();
    sky->drawFor({lighting.sunDirection, lighting.moonDirection, lighting.moonPart});
    lighting.sky = &*sky;
  }
  return lighting;
}

glm::dmat4 reversedClipFromRelativeWorld(const Camera& camera) {
  glm::dmat4 clipFromEye = camera.clipFromEye();
  for (int column = 0; column < 4; ++column) clipFromEye[column][2] = 0.0;
  clipFromEye[3][2] = camera.nearDistance;
  return clipFromEye * camera.eyeFromRelativeWorld();
}

}  // namespace seaway::render
