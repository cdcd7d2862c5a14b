#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "render/lighting_decision.h"
#include "render/scene_object.h"
#include "render/shading/pixel_shader.h"
#include "render/shadow_maps.h"
#include "render/technique_choice.h"
#include "sim_bridge/cost/study.h"
#include "sim_bridge/scene_view.h"

namespace seaway::bridge {
namespace {

/// Off a surface by as much a ray to the sun begins, m: what is drawn is rounded.
constexpr double lift = 0.005;
constexpr double lowest = -0.05;  // m: what lies deeper in still water is lit by bent rays

/// A lit place that a pixel shows, relative to the camera.
struct LitPlace {
  glm::dvec3 place, normal;
  bool isLit = false;
};

bool meets(const glm::dvec3& from, const glm::dvec3& ray, const glm::dvec3 (&corners)[3]) {
  // Möller & Trumbore 1997.
  const glm::dvec3 u = corners[1] - corners[0], v = corners[2] - corners[0];
  const glm::dvec3 p = glm::cross(ray, v);
  const double determinant = glm::dot(u, p);
  if (std::abs(determinant) < 1e-12) return false;
  const glm::dvec3 off = from - corners[0], q = glm::cross(off, u);
  const double a = glm::dot(off, p) / determinant, b = glm::dot(ray, q) / determinant;
  return a >= 0.0 && b >= 0.0 && a + b <= 1.0 && glm::dot(v, q) / determinant > 0.0;
}

bool seesSun(const LitPlace& place, const glm::dvec3& sun, const render::View& view) {
  const glm::dvec3 from = place.place + lift * place.normal;
  for (const render::SceneObject& object : view.objects) {
    const glm::dvec3 centre = render::relativePosition(object, view.camera);
    const double along = glm::dot(centre - from, sun);
    const double radius = object.mesh->boundingRadius;
    if (along < -radius || glm::length(centre - from - along * sun) > radius) continue;
    const glm::dmat3 rotation(glm::mat3_cast(object.worldFromBody));
    for (const render::Mesh::Part& part : object.mesh->parts) {
      for (std::size_t i = 0; i + 2 < part.vertices.size(); i += 3) {
        glm::dvec3 corners[3];
        for (int k = 0; k < 3; ++k) {
          corners[k] = rotation * glm::dvec3(part.vertices[i + k]) + centre;
        }
        if (meets(from, sun, corners)) return false;
      }
    }
  }
  return true;
}

/// Places of objects and water that face the sun, of a frame with normals.
std::vector<LitPlace> litPlaces(const render::View& view, const render::Frame& frame,
                                const glm::dvec3& sun) {
  std::vector<LitPlace> places;
  for (int y = 0; y < view.camera.size.y; ++y) {
    for (int x = 0; x < view.camera.size.x; ++x) {
      const std::size_t i = static_cast<std::size_t>(y) * view.camera.size.x + x;
      const bool isWater = frame.classes[i] == render::PixelClass::water;
      if (!isWater && frame.classes[i] != render::PixelClass::object) continue;
      const glm::dvec3 ray = view.camera.rayThrough(glm::dvec2(x, y));
      const double axial = frame.depth.metres[i];
      LitPlace place{ray * (axial / glm::dot(ray, view.camera.forward())),
                     glm::dvec3(frame.normals[i])};
      // Water casts no shadow: it is lit from above.
      if (isWater) place.normal = glm::dvec3(0.0, 0.0, 1.0);
      if (glm::dot(place.normal, sun) < 0.05) continue;
      if (!isWater && place.place.z + view.camera.position.z < lowest) continue;
      place.isLit = seesSun(place, sun, view);
      places.push_back(place);
    }
  }
  return places;
}

/// Sunlight alone, as shading sees it at a place, over what it is without shadows.
bool isLit(const LitPlace& place, render::ShadingConstants& constants,
           const render::ShadowMaps& maps) {
  render::PixelSpan span{};
  span.count = 1;
  span.firstRay = glm::vec3(place.place);
  span.kind[0] = render::ShadedAs::object;
  span.axial[0] = 1.0f;
  span.hasObjects = true;
  for (int c = 0; c < 3; ++c) {
    span.normal[c][0] = static_cast<float>(place.normal[c]);
    span.reflectance[c][0] = 1.0f;
  }
  glm::vec4 light[16], bare[16];
  const int count = constants.shadowCount;
  const render::ShadingSources sources{
      .constants = constants, .shadows = maps.texels().data(), .shadowWidth = maps.size().x};
  render::shadeSpan(sources, span, light);
  constants.shadowCount = 0;
  render::shadeSpan(sources, span, bare);
  constants.shadowCount = count;
  return light[0].g > 0.5f * bare[0].g;
}

/// Shading with the sun alone.
render::ShadingConstants sunAlone(const render::View& view, const render::Lighting& lighting) {
  render::ShadingConstants c = render::shadingConstants(view, lighting);
  c.skyIsOn = c.hazeIsOn = c.cameraIsUnderWater = c.waterlineIsOn = false;
  c.skyLight = c.veil = glm::vec3(0.0f);
  c.lampCount = 0;
  c.stillWater = -1e30f;  // water is looked at where it is drawn, as dry
  return c;
}

/// A frame of the first camera that sees shadows; its view is left in `view`.
bool drawShadowed(const Scene& scene, const Simulation& simulation, SceneView& sceneView,
                  glm::ivec2 size, EffectLedger& ledger, render::View& view, render::Frame& frame) {
  const auto technique = render::makeTechnique({.grid = scene.accuracy.grid});
  for (const SceneCamera& camera : scene.cameras) {
    EffectLedger own(scene.effects);
    view = sceneView.view(simulation, camera, size, own);
    view.wantsNormals = true;
    technique->drawInto(view, frame);
    view.effects = &ledger;
    const auto report = own.report()[static_cast<std::size_t>(Effect::shadows)];
    if (report.state == EffectState::on && report.memoryBytes > 0) return true;
  }
  return false;
}

}  // namespace

std::vector<Study> studyShadows(const Scene& scene, const Sea& sea, const StudyOptions& options) {
  const glm::ivec2 size = options.quick ? glm::ivec2(160, 90) : glm::ivec2(320, 180);
  const Simulation simulation(scene, sea);
  SceneView sceneView(scene);
  EffectLedger ledger(scene.effects);
  render::View view;
  render::Frame frame;
  if (!drawShadowed(scene, simulation, sceneView, size, ledger, view, frame)) return {};
  render::Lighting lighting;
  lighting.sunIsOn = true;
  lighting.sunDirection = render::sunDirectionOf(view);
  const std::vector<LitPlace> places = litPlaces(view, frame, glm::dvec3(lighting.sunDirection));
  const auto shaded = std::count_if(places.begin(), places.end(),
                                    [](const LitPlace& place) { return !place.isLit; });
  if (shaded == 0) return {};
  Study study{"light_shadows",
              "pixels whose sunlight is wrong, in % of the " + std::to_string(shaded) +
                  " in shadow, by the most texels a map's side has; truth: a ray to the sun from "
                  "each, " +
                  std::to_string(size.x) + "x" + std::to_string(size.y) + " pixels",
              "%",
              "ms/frame",
              {}};
  render::ShadowMaps maps;
  render::ShadingConstants constants = sunAlone(view, lighting);
  for (const int side : {64, 128, 256, 512, 1024, 2048}) {
    const Timing timing =
        timeRepeated([&] { maps.fill(view, {.water = true, .objects = true}, lighting, side); },
                     options.quick ? 3 : 5);
    maps.setConstants(constants);
    const auto wrong = std::count_if(places.begin(), places.end(), [&](const LitPlace& place) {
      return isLit(place, constants, maps) != place.isLit;
    });
    study.points.push_back({std::to_string(side) + " texels",
                            100.0 * static_cast<double>(wrong) / static_cast<double>(shaded),
                            1e3 * timing.median, 1e3 * timing.spread, static_cast<double>(side)});
  }
  study.chosen = std::to_string(render::ShadowMaps::side) + " texels";
  return {study};
}

}  // namespace seaway::bridge
