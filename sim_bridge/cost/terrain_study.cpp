#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "render/terrain/terrain_in_view.h"
#include "sim_bridge/cost/study.h"
#include "sim_bridge/output/number_text.h"
#include "sim_bridge/scene_view.h"
#include "surface/curvature.h"

namespace seaway::bridge {
namespace {

/// How far drawn ground is off the map's heights, px rms, and over how many pixels.
struct GroundError {
  double squares = 0.0;
  long pixels = 0;
  double rms() const { return pixels > 0 ? std::sqrt(squares / static_cast<double>(pixels)) : 0.0; }
};

GroundError errorOf(const render::Strip& strip, const TerrainMap& map,
                    const render::Camera& camera) {
  GroundError error;
  for (int y = 0; y < strip.rows; ++y) {
    for (int x = 0; x < strip.width; ++x) {
      const double inverse = strip.inverse[static_cast<std::size_t>(y) * strip.stride + x];
      if (inverse == 0.0) continue;
      const glm::dvec3 ray = camera.rayThrough({x, y});
      const double range = 1.0 / (inverse * glm::dot(ray, camera.forward()));
      const glm::dvec2 level = range * glm::dvec2(ray);
      const double height = camera.position.z + range * ray.z + seaDrop(glm::length(level));
      const double truth = map.heightAt(glm::dvec2(camera.position) + level);
      if (std::isinf(truth) || height < 0.0) continue;
      const double off = std::abs(height - truth) * inverse / camera.pixelExtent().y;
      error.squares += off * off;
      ++error.pixels;
    }
  }
  return error;
}

}  // namespace

std::vector<Study> studyTerrain(const Scene& scene, const Sea& sea, const StudyOptions& options) {
  const TerrainMap* map = sea.surface.terrain();
  if (!map) return {};
  const glm::ivec2 size = options.quick ? glm::ivec2(320, 180) : glm::ivec2(1280, 720);
  const Simulation simulation(scene, sea);
  SceneView sceneView(scene);
  EffectLedger ledger(scene.effects);
  Study study{"image_terrain",
              "height of drawn ground off the map's own where pixels lie, rms, by the tolerance of "
              "its levels of detail; all cameras of the scene, " +
                  std::to_string(size.x) + "x" + std::to_string(size.y) + " pixels",
              "px",
              "ms/frame",
              {}};
  const render::TerrainLod levels(*map);
  for (const double tolerance : {0.0, 0.175, 0.35, 0.7, 1.4, 2.8, 5.6}) {
    GroundError error;
    double seconds = 0.0, spread = 0.0;
    std::size_t triangles = 0;
    for (const SceneCamera& each : scene.cameras) {
      const render::Camera camera = sceneView.view(simulation, each, size, ledger).camera;
      render::TerrainInView::Triangles ground;
      render::Strip strip;
      std::vector<glm::vec3> corners;
      const auto draw = [&] {
        corners.clear();
        levels.select(*map, camera, {.tolerance = tolerance, .lowest = 0.0}, corners);
        render::bendToSea(camera, corners);
        ground.fill(corners, camera);
        strip.clear(0, size.y, size.x, false);
        ground.raster(strip);
      };
      const Timing timing = timeRepeated(draw, options.quick ? 3 : 5);
      seconds += timing.median / static_cast<double>(scene.cameras.size());
      spread = std::max(spread, timing.spread);
      triangles += corners.size() / 3 / scene.cameras.size();
      const GroundError one = errorOf(strip, *map, camera);
      error.squares += one.squares;
      error.pixels += one.pixels;
    }
    const std::string setting = tolerance > 0.0 ? numberText(tolerance) + " px" : "all cells";
    study.points.push_back({setting + ", " + std::to_string(triangles) + " triangles", error.rms(),
                            1e3 * seconds, 1e3 * spread, tolerance});
  }
  return {study};
}

}  // namespace seaway::bridge
