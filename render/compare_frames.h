#pragma once

#include "render/camera.h"
#include "render/frame.h"

namespace seaway::render {

/// How a frame's water differs from a reference's of the same view.
struct FrameComparison {
  double depthMedian = 0.0;  ///< |axial depth − reference's|, m
  double positionRms = 0.0;  ///< pixels: the surface's place in the picture, see compareFrames
  double positionPercentile99 = 0.0;  ///< pixels
  std::size_t compared = 0;           ///< pixels of water in both, away from silhouettes
  std::size_t missing = 0;            ///< pixels that are water in the reference alone
  std::size_t extra = 0;              ///< pixels that are water in the frame alone
  std::size_t misplaced = 0;          ///< of both, those farther than 2 pixels from a silhouette
};

/// Compares the water of two frames; pixels that show an object in either are left out.
///
/// A pixel's surface point is brought back to the world by the frame's depth. Its distance from the
/// reference's surface (a plane by depth and normal) along the reference's normal, projected to the
/// picture, is the pixels by which the surface is out of place. Silhouettes of the reference are
/// where neighbours differ in class, or in depth by a ratio of more than 1.1; pixels within 2 of
/// them count neither for depth nor for place. `reference` has normals.
FrameComparison compareFrames(const Camera& camera, const Frame& frame, const Frame& reference);

}  // namespace seaway::render
