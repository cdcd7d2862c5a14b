#pragma once

#include <functional>
#include <glm/vec2.hpp>

#include "surface/disturbance/layers/surface_layer.h"

namespace seaway {

/// The hull that leaves a trail.
struct TrailHull {
  double length = 12.0;  ///< m, > 0
  double beam = 3.5;     ///< m, > 0
};

/// Where a hull is, in the sea plane, and how it moves through the water.
struct TrailPose {
  glm::dvec2 position{0.0};  ///< amidships, m
  double direction = 0.0;    ///< of the bow, rad counter-clockwise from east
  glm::dvec2 velocity{0.0};  ///< relative to the water, m/s
};

/// How white a hull's trail is at a speed through the water: 0 below a Froude number of 0.1, 0.9
/// from 0.5 on. (A look: no measured law.)
double trailStrength(const TrailHull& hull, double speed);

/// Leaves on `foam` and `smooth` what a hull leaves in the water between `from` and `to` s: foam
/// along its sides and behind it, smoothed water in its path, patchy, both widening as a turbulent
/// wake without net momentum does (with the fifth root of the distance) by strokes at places that
/// the hull has passed a while ago. `poseAt(t)` tells the past as far as 120 s before `from`.
/// A hull below half a knot leaves nothing. Strokes that a layer refuses are left out.
void paintTrail(const TrailHull& hull, const std::function<TrailPose(double)>& poseAt, double from,
                double to, SurfaceLayer& foam, SurfaceLayer& smooth);

/// A round patch with ragged edges, `cover` in its middle, as a splash leaves.
Painted paintPatch(glm::dvec2 place, double radius, double cover, double t, SurfaceLayer& layer);

}  // namespace seaway
