#pragma once

#include <span>
#include <vector>

#include "render/pixel_box.h"
#include "render/render_technique.h"
#include "render/software/raster.h"

/// Rooms of open hulls, out of which the picture keeps the sea.
namespace seaway::render {

/// A mesh's hollow placed relative to the camera, sea-plane axes, m: inside, dot(n, p) < w for all
/// planes (n, w).
struct PlacedHollow {
  std::vector<glm::vec4> planes;
  glm::vec3 middle{0.0f};  ///< of a ball around its mesh
  float radius = 0.0f;
};

/// Decides on the `hull_mask` effect with the view's ledger: hollows of objects in view, none where
/// it is off or water is not shown.
std::vector<PlacedHollow> decideHollows(const View& view, bool waterIsShown);

/// Pixels that a hollow may cover: those of its ball, or all where the camera is in the ball.
PixelBox pixelsOf(const PlacedHollow& hollow, const Camera& camera);

/// Takes the sea out of a strip where its surface lies in a hollow; before objects are drawn.
/// shaders/hull_mask.frag is its twin.
void cutHollows(std::span<const PlacedHollow> hollows, const Camera& camera, Strip& strip);

}  // namespace seaway::render
