#pragma once

#include "render/render_technique.h"

namespace seaway::render {

/// How a camera moves from frame to frame.
struct CameraMotion {
  glm::dvec3 step{0.0};  ///< m a frame, sea-plane axes
  double turn = 0.0;     ///< rad a frame about the vertical, counter-clockwise
};

/// Swimming: how much the drawn surface changes a frame because the grid moves with the camera
/// though the sea does not, pixels rms.
///
/// Each frame's view is drawn by `technique` with the grid of its own camera and with that of the
/// frame before; the distance between the two surfaces is compareFrames' `positionRms`. The root of
/// its mean square over `frames` ≥ 1 frames after the first; 0 where no water was compared. Time
/// stands still at `view.time`. Johanson 2004, "Evaluation".
double swimming(RenderTechnique& technique, View view, const CameraMotion& motion, int frames);

}  // namespace seaway::render
