#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <utility>

#include "render/camera.h"
#include "render/pixel_box.h"

namespace seaway::render {

/// Camera-relative places to the picture: pixel (0, 0) is the centre of the top left one.
struct ScreenProjection {
  explicit ScreenProjection(const Camera& camera);

  glm::vec3 forward, right, down;  ///< right and down: pixels from the middle at 1 m
  glm::vec2 middle;                ///< the view axis in the picture
  float nearest;                   ///< axial distance, m, below which a place has no pixel
};

/// A triangle in the picture: corners in pixels with 1/axial distance, turning either way.
struct ScreenTriangle {
  double x[3], y[3], inverse[3];
  std::uint32_t object = 0;  ///< 0: sea
};

/// Clips a triangle of camera-relative corners at the near plane and projects what is left: none,
/// one or two triangles, put into `out`. Returns how many.
int projectTriangle(const glm::vec3 (&corners)[3], const ScreenProjection& projection,
                    ScreenTriangle (&out)[2]);

/// Pixels of a picture that triangles may cover.
PixelBox boxOf(std::span<const ScreenTriangle> triangles, glm::ivec2 picture);

/// Least and largest axial distance of their corners, m; (1e30, 0) of none.
std::pair<float, float> axialRangeOf(std::span<const ScreenTriangle> triangles);

}  // namespace seaway::render
