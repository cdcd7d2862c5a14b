#pragma once

#include <optional>

#include "render/render_technique.h"
#include "render/shading/shading_constants.h"
#include "render/shading/sky_dome.h"

namespace seaway::render {

/// What of a scene a frame shows.
struct Shown {
  bool water = false, objects = false, terrain = false;
  bool cameraIsUnderWater = false;  ///< in all pixels
  bool anyUnderWater = false;       ///< in some
};

/// Decides on sun and sky with the view's ledger; makes and draws `sky` where it is called for.
Lighting decideLighting(const View& view, const Shown& shown, std::optional<SkyDome>& sky);

/// Depth runs from 1 at the near plane to 0 at infinity, which spreads a float's precision evenly
/// over distances; nothing is cut off far away.
glm::dmat4 reversedClipFromRelativeWorld(const Camera& camera);

}  // namespace seaway::render
