#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "render/camera.h"

namespace seaway::render {

/// The shadow of V_visible on the still-water plane: every place whose water may be in the picture.
///
/// Tighter than the hull of VisibleVolume's corners, since the bounds of the waves follow the
/// curved sea from strip to strip. Lengths in m from the camera's foot point, `along` an azimuth
/// and across to its right.
class VisibleShadow {
 public:
  struct Interval {
    double least = 0.0, most = 0.0;
  };
  /// A quadrilateral between two lines across the azimuth.
  struct Strip {
    Interval near, far;
  };

  VisibleShadow() = default;
  /// `heightBound` m > 0: no wave passes ± this; `azimuth` a unit vector; nothing farther than
  /// `reach` m counts.
  VisibleShadow(const Camera& camera, double heightBound, glm::dvec2 azimuth, double reach);

  /// Covers the shadow from `near` to `far` > `near`, and little more; empty where there is none.
  std::optional<Strip> cover(double near, double far) const;

 private:
  /// Along, across, up from the eye.
  struct Plane {
    glm::dvec3 normal{0.0};
    double offset = 0.0;  // inside: dot(normal, p) >= offset
  };
  struct Edge {
    glm::dvec3 start{0.0}, direction{0.0};
    double length = 0.0;  // in `direction`s
  };
  /// Part of the volume between two lines and two heights: a convex polyhedron.
  struct Piece {
    double near, far, bottom, top;
  };
  Interval level(double along, double height) const;
  Interval cut(double along, const Piece& piece) const;
  template <typename Use>
  void forCornersOf(const Piece& piece, Use use) const;
  std::optional<Strip> coverPiece(const Piece& piece) const;

  std::array<Plane, 5> planes_{};  // of the camera's frustum, the far plane left out
  std::array<Edge, 8> edges_{};
  double eyeHeight_ = 0.0, bound_ = 0.0, reach_ = 0.0;
};

}  // namespace seaway::render
