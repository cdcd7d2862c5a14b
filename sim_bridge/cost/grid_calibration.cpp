#include <algorithm>
#include <cmath>

#include "render/grid_error.h"
#include "render/grid_placement.h"
#include "render/technique_choice.h"
#include "render/unproject.h"
#include "sim_bridge/cost/calibration.h"
#include "sim_bridge/cost/study.h"
#include "sim_bridge/scene_view.h"

namespace seaway::bridge {
namespace {

/// Adds the pixels of one picture.
void addPixels(const render::View& view, int stride, GridCheck& sum) {
  const glm::ivec2 grid(sum.side);
  const render::Frame frame = render::makeTechnique({.grid = grid})->draw(view);
  if (frame.stats.boundRedraws > 0) return;  // its grid lies elsewhere than foreseen here
  render::GridLayout layout;
  render::FrameStats stats;
  const auto place = [&](const render::Projector& projector) {
    layout = render::projectedLayout(projector, view.water->waves(), grid);
    return render::SeaPlacement{.vertices = 1};
  };
  if (!render::placeSea(view, render::ProjectedGridOptions{}.projectorElevation, place, stats)) {
    return;
  }
  const render::GridError foreseen(view.water->waves(), layout);
  const SurfaceAtTime now = view.water->at(view.time);
  for (int y = stride / 2; y < view.camera.size.y; y += stride) {
    for (int x = stride / 2; x < view.camera.size.x; x += stride) {
      const std::size_t i = static_cast<std::size_t>(y) * view.camera.size.x + x;
      if (frame.classes[i] != render::PixelClass::water) continue;
      const render::SeaPoint seen =
          render::unproject(view.camera, glm::dvec2(x, y), frame.depth.metres[i]);
      const double error = std::abs(seen.height - now.sample(seen.point).height);
      if (!std::isfinite(error)) continue;  // dry
      const double deviation =
          foreseen.standardDeviationAt(seen.point - glm::dvec2(view.camera.position));
      sum.predicted += deviation * deviation;
      sum.measured += error * error;
      for (std::size_t k = 0; k < 3; ++k) {
        sum.within[k] += error <= (static_cast<double>(k) + 1.0) * deviation;
      }
      ++sum.pixels;
    }
  }
}

}  // namespace

std::vector<GridCheck> checkGrids(const Scene& scene, const Sea& sea, const StudyOptions& options) {
  std::vector<GridCheck> checks;
  if (scene.cameras.empty()) return checks;
  const Simulation simulation(scene, sea);
  SceneView sceneView(scene);
  EffectLedger ledger(scene.effects);
  const glm::ivec2 size = options.quick ? glm::ivec2(320, 180) : glm::ivec2(640, 360);
  render::View view = sceneView.view(simulation, findCamera(scene, ""), size, ledger);
  view.camera.distortion.reset();  // a lens has a grid of its own
  for (const int side : {64, 128, 256, 512}) {
    GridCheck sum{side, 0, 0.0, 0.0, {}};
    // Near the camera a picture shows few waves: several of them, 61 s apart.
    for (int moment = 0; moment < 6; ++moment) {
      view.time = 61.0 * moment;
      if (!render::cameraIsUnderWater(view)) addPixels(view, options.quick ? 4 : 3, sum);
    }
    if (sum.pixels == 0) continue;
    const double all = sum.pixels;
    sum.predicted = std::sqrt(sum.predicted / all);
    sum.measured = std::sqrt(sum.measured / all);
    for (double& share : sum.within) share /= all;
    checks.push_back(sum);
  }
  return checks;
}

}  // namespace seaway::bridge
