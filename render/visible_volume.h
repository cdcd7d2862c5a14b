#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "render/camera.h"

namespace seaway::render {

/// The part of the sea's displaceable volume that a camera can see: Johanson's V_visible, the
/// intersection of V_cam (the frustum) with V_displaceable (between the bound planes).
struct VisibleVolume {
  /// Its corners, m: x and y relative to the camera's foot point, z above the still-water level.
  std::vector<glm::dvec3> corners;
  /// Horizontal distance from the foot point beyond which there is none of it, m. Corners of a wide
  /// view's far plane may lie farther.
  double reach = 0.0;
  /// Half its thickness, m: a little more than the height bound, so that still water has some.
  double bound = 0.0;
};

/// `heightBound` m ≥ 0: no wave passes ± this. The lower plane lies deeper by what the curved sea
/// drops within the volume; the far plane lies where the last crests dip below the horizon, not at
/// `camera.farDistance`. Empty where no water can be in the picture.
///
/// Source: Johanson 2004, "Creating the range conversion matrix".
std::optional<VisibleVolume> visibleVolume(const Camera& camera, double heightBound);

}  // namespace seaway::render
