#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "surface/terrain/terrain_map.h"
#include "tests/render/seas.h"

/// Terrains and ways of drawing that the tests of render/terrain share.
namespace seaway::render::test {

/// Heights by a function of place about the origin.
inline std::shared_ptr<const TerrainMap> ground(glm::ivec2 count, double spacing,
                                                const std::function<double(glm::dvec2)>& height,
                                                const TerrainLook& look = {}) {
  TerrainMap::Grid grid{-0.5 * spacing * glm::dvec2(count - 1), glm::dvec2(spacing), count, {}};
  for (int row = 0; row < count.y; ++row) {
    for (int column = 0; column < count.x; ++column) {
      const glm::dvec2 place = grid.origin + spacing * glm::dvec2(column, row);
      grid.heights.push_back(static_cast<float>(height(place)));
    }
  }
  return std::make_shared<const TerrainMap>(std::move(grid), look);
}

/// Hills and hollows of many sizes about an island in the middle.
inline double roughIsland(glm::dvec2 p, double size) {
  double sum = 0.35 * size * (0.5 - std::hypot(p.x, p.y) / size);
  double length = 0.5 * size, weight = 0.05 * size;
  for (int i = 0; i < 6; ++i, length *= 0.47, weight *= 0.45) {
    sum += weight * std::sin(6.28 * (p.x + 0.3 * i * p.y) / length + i) *
           std::cos(6.28 * (p.y - 0.2 * i * p.x) / length - 2.0 * i);
  }
  return 0.3 * sum;
}

/// A camera that looks in a direction of the sea plane, counter-clockwise from east.
inline Camera looking(glm::dvec3 position, double direction_deg, double pitch_deg,
                      double fov_deg = 60.0, glm::ivec2 size = {160, 90}) {
  Camera camera = cameraAt(position, pitch_deg, 0.0, fov_deg, size);
  camera.worldFromCamera =
      attitude(radiansFromDegrees(direction_deg), radiansFromDegrees(pitch_deg), 0.0);
  return camera;
}

struct Way {
  std::string name;
  std::function<std::unique_ptr<RenderTechnique>()> make;
};

/// Every technique and variant that draws all of a sea.
inline std::vector<Way> allWays(glm::ivec2 grid) {
  std::vector<Way> ways{{"software", [=] { return makeSoftwareGrid({.grid = grid}); }},
                        {"radial_grid", [=] { return makeRadialGrid({.grid = grid}); }},
                        {"post_process", [=] { return makePostProcess({.grid = grid}); }},
                        {"reference", [=] { return makeReference({.grid = grid}); }}};
  for (const GridVariant variant : {GridVariant::cpuVertices, GridVariant::gpu,
                                    GridVariant::cpuVerticesGpuNormals, GridVariant::marched}) {
    ways.push_back({std::string(gridVariantName(variant)), [=] {
                      return makeProjectedGrid(sharedContext(), {.grid = grid, .variant = variant});
                    }});
  }
  return ways;
}

struct Picture {
  Frame frame;
  std::vector<EffectReport> report;
  const EffectReport& operator[](Effect effect) const {
    return report[static_cast<std::size_t>(effect)];
  }
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * frame.depth.size.x + x;
  }
  PixelClass at(int x, int y) const { return frame.classes[index(x, y)]; }
};

inline Picture picture(RenderTechnique& technique, const WaterSurface& water, const Camera& camera,
                       const EffectSettings& settings = {}, double windSpeed = 7.0) {
  EffectLedger effects(settings);
  View view;
  view.water = &water;
  view.time = 3.0;
  view.camera = camera;
  view.light.windSpeed = windSpeed;
  view.effects = &effects;
  Picture result;
  result.frame = technique.draw(view);
  result.report = effects.report();
  return result;
}

}  // namespace seaway::render::test
