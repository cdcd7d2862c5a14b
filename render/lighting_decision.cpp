#include "render/lighting_decision.h"

#include <algorithm>

#include "render/scene_object.h"

namespace seaway::render {
namespace {

/// Whether any ray of the picture goes above the horizontal: if one does, one at a corner does.
bool seesAboveHorizon(const Camera& camera) {
  const glm::dvec2 last = glm::dvec2(camera.size) - 0.5;
  for (const glm::dvec2 pixel :
       {glm::dvec2(-0.5, -0.5), glm::dvec2(last.x, -0.5), glm::dvec2(-0.5, last.y), last}) {
    if (camera.rayThrough(pixel).z > 0.0) return true;
  }
  return false;
}

}  // namespace

Lighting decideLighting(const View& view, const Shown& shown, std::optional<SkyDome>& sky) {
  Lighting lighting;
  lighting.waterIsOn = shown.water;
  lighting.cameraIsUnderWater = shown.cameraIsUnderWater;
  lighting.sunDirection = sunDirectionOf(view);
  const bool sunIsUp = lighting.sunDirection.z > -0.01f;  // its disc is half a degree wide
  const bool skyIsSeen = shown.water || seesAboveHorizon(view.camera);
  const bool sunIsSeen = sunIsUp && (skyIsSeen || shown.objects);
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
