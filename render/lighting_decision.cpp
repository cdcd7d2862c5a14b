#include "render/lighting_decision.h"

#include <algorithm>

#include "render/scene_object.h"
#include "render/shading/shading_tables.h"
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
    called = lies || blows || wakes;
    reason = blows   ? "the wind raises whitecaps"
             : lies  ? "foam lies on the water"
             : wakes ? "a wake may break"
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
  const char* reason = shown.water ? "water reflects it"
                       : skyIsSeen ? "the camera sees above the horizon"
                                   : "nothing shows or reflects it";
  if (view.effects->decide(Effect::sky, skyIsSeen, reason)) {
    if (!sky) sky.emplace();
    sky->drawFor(lighting.sunDirection);
    lighting.sky = &*sky;
  }
  return lighting;
}

bool decideObjects(const View& view) {
  const bool anyInView = std::any_of(view.objects.begin(), view.objects.end(),
                                     [&](const auto& o) { return inView(o, view.camera); });
  return view.effects->decide(
             Effect::vesselMeshes, anyInView,
             anyInView ? "a vessel is in the camera's view" : "no vessel in view") &&
         anyInView;
}

glm::dmat4 reversedClipFromRelativeWorld(const Camera& camera) {
  glm::dmat4 clipFromEye = camera.clipFromEye();
  for (int column = 0; column < 4; ++column) clipFromEye[column][2] = 0.0;
  clipFromEye[3][2] = camera.nearDistance;
  return clipFromEye * camera.eyeFromRelativeWorld();
}

}  // namespace seaway::render
