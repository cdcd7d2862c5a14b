#include "render/swimming.h"

#include <cmath>

#include "render/compare_frames.h"

namespace seaway::render {
namespace {

Camera moved(Camera camera, const CameraMotion& motion) {
  camera.position += motion.step;
  camera.worldFromCamera =
      glm::angleAxis(motion.turn, glm::dvec3(0.0, 0.0, 1.0)) * camera.worldFromCamera;
  return camera;
}

}  // namespace

double swimming(RenderTechnique& technique, View view, const CameraMotion& motion, int frames) {
  view.wantsNormals = true;
  view.objects = {};
  Frame own, before;
  double squares = 0.0;
  std::size_t compared = 0;
  for (int i = 0; i < frames; ++i) {
    const Camera last = view.camera;
    view.camera = moved(last, motion);
    view.gridCamera = nullptr;
    technique.drawInto(view, own);
    view.gridCamera = &last;
    technique.drawInto(view, before);
    const FrameComparison change = compareFrames(view.camera, before, own);
    const auto pixels = static_cast<double>(change.compared);
    squares += change.positionRms * change.positionRms * pixels;
    compared += change.compared;
  }
  return compared > 0 ? std::sqrt(squares / static_cast<double>(compared)) : 0.0;
}

}  // namespace seaway::render
