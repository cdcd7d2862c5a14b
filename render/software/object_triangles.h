#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "render/pixel_box.h"
#include "render/render_technique.h"
#include "render/shading/pixel_shader.h"
#include "render/software/raster.h"

namespace seaway::render {

/// Scene objects as triangles in the picture, and how each is shaded.
class ObjectTriangles {
 public:
  void fill(std::span<const SceneObject> objects, const Camera& camera);
  void raster(Strip& strip) const;
  std::span<const ScreenTriangle> triangles() const { return triangles_; }

  /// Pixels of the strip that the triangles may touch.
  PixelBox boxIn(const Strip& strip) const;

  /// Makes those pixels of the span that show an object ones to be shaded so. `which` as
  /// Strip::object, `inverse` as Strip::inverse.
  void fillSpan(const std::uint32_t* which, const float* inverse, PixelSpan& span) const;

  std::size_t memoryBytes() const;

 private:
  struct Face {
    glm::vec3 normal, colour;
  };
  std::vector<ScreenTriangle> triangles_;
  std::vector<Face> faces_;  // of object number − 1
};

}  // namespace seaway::render
