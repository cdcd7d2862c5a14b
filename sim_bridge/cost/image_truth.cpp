#include "sim_bridge/cost/image_truth.h"

#include <algorithm>
#include <cmath>

#include "render/compare_frames.h"
#include "render/unproject.h"
#include "sim_bridge/cost/study.h"
#include "surface/surface_ray.h"

namespace seaway::bridge {
namespace {

/// Rows closer than a tenth of a pixel: what this grid's band limit leaves out no pixel shows.
constexpr glm::ivec2 finestGrid(4096, 4096);

}  // namespace

std::string sizeText(glm::ivec2 size) {
  return std::to_string(size.x) + "x" + std::to_string(size.y);
}

ImageTruth::ImageTruth(const Scene& scene, const Sea& sea, const StudyOptions& options)
    : simulation_(scene, sea), sceneView_(scene), ledger_(scene.effects) {
  const SceneCamera& camera = findCamera(scene, "");
  const glm::ivec2 size = options.quick ? glm::ivec2(320, 180) : glm::ivec2(640, 360);
  where_ = ", camera '" + camera.name + "', " + sizeText(size) + " pixels";
  view_ = sceneView_.view(simulation_, camera, size, ledger_);
  marchRays(options.quick ? 8 : 4);
  if (!showsWater()) return;
  view_.wantsNormals = true;
  rays_ = render::makeReference({.grid = finestGrid})->draw(view_);
  view_.wantsNormals = false;
}

/// Depths of every `stride`-th pixel that shows water.
void ImageTruth::marchRays(int stride) {
  const render::Camera& camera = view_.camera;
  const SurfaceAtTime now = view_.water->at(view_.time);
  for (int y = stride / 2; y < camera.size.y; y += stride) {
    for (int x = stride / 2; x < camera.size.x; x += stride) {
      const glm::dvec3 ray = camera.rayThrough(glm::dvec2(x, y));
      const auto distance = distanceToWater(now, camera.position, ray);
      if (distance) marched_.push_back({{x, y}, *distance * glm::dot(ray, camera.forward())});
    }
  }
}

ImageErrors ImageTruth::errorsOf(const render::Frame& frame) const {
  std::vector<double> depth;
  double squares = 0.0;
  for (const TruePixel& pixel : marched_) {
    const auto index = static_cast<std::size_t>(pixel.pixel.y * frame.depth.size.x + pixel.pixel.x);
    if (frame.classes[index] != render::PixelClass::water) continue;
    const double drawn = frame.depth.metres[index];
    const render::SeaPoint point = render::unproject(view_.camera, glm::dvec2(pixel.pixel), drawn);
    depth.push_back(std::abs(drawn - pixel.axialDepth));
    squares += std::pow(point.height - view_.water->sample(point.point, view_.time).height, 2);
  }
  ImageErrors errors{std::nan(""), std::nan(""), std::nan("")};
  if (depth.empty()) return errors;
  const auto middle = depth.begin() + static_cast<std::ptrdiff_t>(depth.size() / 2);
  std::nth_element(depth.begin(), middle, depth.end());
  errors.position = render::compareFrames(view_.camera, frame, rays_).positionRms;
  errors.depth = *middle;
  errors.height = std::sqrt(squares / static_cast<double>(depth.size()));
  return errors;
}

}  // namespace seaway::bridge
