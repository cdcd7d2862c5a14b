#include <algorithm>
#include <cmath>

#include "render/compare_frames.h"
#include "render/technique_choice.h"
#include "render/unproject.h"
#include "sim_bridge/cost/study.h"
#include "sim_bridge/scene_view.h"
#include "surface/surface_ray.h"

namespace seaway::bridge {
namespace {

/// Rows closer than a tenth of a pixel: what this grid's band limit leaves out no pixel shows.
constexpr glm::ivec2 finestGrid(4096, 4096);

/// A pixel whose true depth is known.
struct TruePixel {
  glm::ivec2 pixel;
  double axialDepth;  // m
};

/// Ray-marched depths of every `stride`-th pixel that shows water.
std::vector<TruePixel> marchedPixels(const render::View& view, int stride) {
  std::vector<TruePixel> pixels;
  const render::Camera& camera = view.camera;
  const SurfaceAtTime now = view.water->at(view.time);
  for (int y = stride / 2; y < camera.size.y; y += stride) {
    for (int x = stride / 2; x < camera.size.x; x += stride) {
      const glm::dvec3 ray = camera.rayThrough(glm::dvec2(x, y));
      const auto distance = distanceToWater(now, camera.position, ray);
      if (distance) pixels.push_back({{x, y}, *distance * glm::dot(ray, camera.forward())});
    }
  }
  return pixels;
}

struct ImageErrors {
  double depth = 0.0;   // median |drawn − marched|, m
  double height = 0.0;  // rms of the field's height against the drawn surface's, m
};

ImageErrors errorsOf(const render::View& view, const render::Frame& frame,
                     const std::vector<TruePixel>& truth) {
  std::vector<double> depth;
  double squares = 0.0;
  for (const TruePixel& pixel : truth) {
    const auto index = static_cast<std::size_t>(pixel.pixel.y * frame.depth.size.x + pixel.pixel.x);
    if (frame.classes[index] != render::PixelClass::water) continue;
    const double drawn = frame.depth.metres[index];
    const render::SeaPoint point = render::unproject(view.camera, glm::dvec2(pixel.pixel), drawn);
    depth.push_back(std::abs(drawn - pixel.axialDepth));
    squares += std::pow(point.height - view.water->sample(point.point, view.time).height, 2);
  }
  if (depth.empty()) return {std::nan(""), std::nan("")};
  const auto middle = depth.begin() + static_cast<std::ptrdiff_t>(depth.size() / 2);
  std::nth_element(depth.begin(), middle, depth.end());
  return {*middle, std::sqrt(squares / static_cast<double>(depth.size()))};
}

}  // namespace

std::vector<Study> studyImageGrid(const Scene& scene, const Sea& sea, const StudyOptions& options) {
  const glm::ivec2 size = options.quick ? glm::ivec2(320, 180) : glm::ivec2(640, 360);
  const std::string where = ", camera '" + findCamera(scene, "").name + "', " +
                            std::to_string(size.x) + "x" + std::to_string(size.y) + " pixels";
  Study place{
      "image_position_grid",
      "place of the surface in the picture, rms away from silhouettes; truth: a ray through "
      "every pixel" +
          where,
      "px",
      "ms/frame",
      {}};
  Study depth{"image_depth_grid",
              "axial depth of water pixels, median; truth: ray-march of the field" + where,
              "m",
              "ms/frame",
              {}};
  Study height{"image_height_grid",
               "height of the drawn surface against the field queried there, rms" + where,
               "m",
               "ms/frame",
               {}};
  const Simulation simulation(scene, sea);
  SceneView sceneView(scene);
  EffectLedger ledger(scene.effects);
  render::View view = sceneView.view(simulation, findCamera(scene, ""), size, ledger);
  const std::vector<TruePixel> truth = marchedPixels(view, options.quick ? 8 : 4);
  if (truth.empty()) return {};
  view.wantsNormals = true;
  const render::Frame rays = render::makeReference({.grid = finestGrid})->draw(view);
  view.wantsNormals = false;
  const std::vector<int> grids = options.quick ? std::vector<int>{32, 128, 512}
                                               : std::vector<int>{32, 64, 128, 256, 512, 1024};
  for (const int side : grids) {
    const auto technique =
        render::makeTechnique({.grid = {side, side}, .backend = options.backend});
    render::Frame frame;
    const Timing timing =
        timeRepeated([&] { frame = technique->draw(view); }, options.quick ? 3 : 5);
    const ImageErrors errors = errorsOf(view, frame, truth);
    const std::string setting = "grid " + std::to_string(side) + "x" + std::to_string(side);
    const auto add = [&](Study& study, double error) {
      study.points.push_back(
          {setting, error, 1e3 * timing.median, 1e3 * timing.spread, static_cast<double>(side)});
    };
    add(place, render::compareFrames(view.camera, frame, rays).positionRms);
    add(depth, errors.depth);
    add(height, errors.height);
  }
  return {place, depth, height};
}

}  // namespace seaway::bridge
