#pragma once

#include <functional>
#include <optional>
#include <string>

#include "render/projector.h"
#include "render/render_technique.h"

namespace seaway::render {

/// What placing a grid on the sea told.
struct SeaPlacement {
  double largestHeight = 0.0;  ///< largest |height| of the grid's vertices, m
  std::size_t vertices = 0;
  std::size_t verticesInFrustum = 0;
};

/// Aims a projector at what the view sees of the sea and has `place` put a grid there; where a wave
/// passes the bounds that the projector was aimed with, again with room for it. Empty where there
/// is no water to draw. Notes vertices and redraws in `stats`.
std::optional<Projector> placeSea(const View& view, double projectorElevation,
                                  const std::function<SeaPlacement(const Projector&)>& place,
                                  FrameStats& stats);

/// Whether the camera is below the water's surface.
bool cameraIsUnderWater(const View& view);

/// Throw InputError for options out of range.
void validate(const ProjectedGridOptions& options);
void validateRings(const std::string& technique, glm::ivec2 grid, double innermost);

}  // namespace seaway::render
