#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <memory>
#include <string>
#include <vector>

#include "render/technique_choice.h"
#include "tests/render/seas.h"

/// Objects on water, for tests of what light does with them.
namespace seaway::render::test {

/// A box between two corners, outside faces counter-clockwise.
inline Mesh boxMesh(glm::vec3 least, glm::vec3 most, glm::vec3 colour) {
  const auto at = [&](int i) {
    return glm::vec3(i & 1 ? most.x : least.x, i & 2 ? most.y : least.y, i & 4 ? most.z : least.z);
  };
  const int faces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                           {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  Mesh mesh;
  mesh.parts.push_back({{}, colour});
  for (const auto& f : faces) {
    for (const int i : {f[0], f[1], f[2], f[0], f[2], f[3]}) {
      mesh.parts[0].vertices.push_back(at(i));
    }
  }
  mesh.boundingRadius = std::max(glm::length(least), glm::length(most));
  return mesh;
}

/// Windless water and things on it.
struct Stage {
  WaterSurface water = stillSea();
  Camera camera;
  std::vector<SceneObject> objects;
  EffectSettings settings{};
  Light light{.sunElevation = 0.6, .sunDirection = 2.0, .windSpeed = 0.0};
  double time = 0.0;
  bool hasWater = true;

  View view(EffectLedger& effects) const {
    View view;
    if (hasWater) view.water = &water;
    view.camera = camera;
    view.time = time;
    view.light = light;
    view.objects = objects;
    view.effects = &effects;
    return view;
  }
  Frame draw(RenderTechnique& technique) const {
    EffectLedger effects(settings);
    return technique.draw(view(effects));
  }
  EffectReport report(RenderTechnique& technique, Effect effect) const {
    EffectLedger effects(settings);
    technique.draw(view(effects));
    return effects.report()[static_cast<std::size_t>(effect)];
  }
  Stage without(Effect effect) const {
    Stage other = *this;
    other.settings[static_cast<std::size_t>(effect)] = EffectSetting::off;
    return other;
  }
};

/// Pixel that shows a place, (0, 0) the centre of the top left one.
inline glm::dvec2 pixelOf(const Camera& camera, glm::dvec3 place) {
  const glm::dvec3 p = place - camera.position;
  const double perPixel = 2.0 * std::tan(0.5 * camera.verticalFieldOfView) / camera.size.y;
  const double axial = glm::dot(p, camera.forward());
  return 0.5 * glm::dvec2(camera.size) - 0.5 +
         glm::dvec2(-glm::dot(p, camera.left()), -glm::dot(p, camera.up())) / (perPixel * axial);
}

/// Sum of the three channels of a pixel, [0, 765].
inline int brightness(const Frame& frame, int x, int y) {
  const std::size_t i = 3 * (static_cast<std::size_t>(y) * frame.colour.size.x + x);
  return frame.colour.rgb[i] + frame.colour.rgb[i + 1] + frame.colour.rgb[i + 2];
}

/// Every way to draw: techniques, and variants of the projected grid through OpenGL.
struct Way {
  std::string name;
  std::unique_ptr<RenderTechnique> technique;
};
inline std::vector<Way> everyWay(glm::ivec2 grid) {
  std::vector<Way> ways;
  ways.push_back({"software", makeSoftwareGrid({.grid = grid})});
  ways.push_back({"radial_grid", makeRadialGrid({.grid = grid})});
  ways.push_back({"post_process", makePostProcess({.grid = grid})});
  ways.push_back({"naive_grid", makeNaiveGrid({.grid = grid, .side = 400.0})});
  ways.push_back({"reference", makeReference({.grid = grid})});
  for (const GridVariant variant : {GridVariant::cpuVertices, GridVariant::gpu,
                                    GridVariant::cpuVerticesGpuNormals, GridVariant::marched}) {
    ways.push_back({std::string(gridVariantName(variant)),
                    makeProjectedGrid(sharedContext(), {.grid = grid, .variant = variant})});
  }
  return ways;
}

}  // namespace seaway::render::test
