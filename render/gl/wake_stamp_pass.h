#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "render/field_twin.h"
#include "render/gl/gl_objects.h"
#include "render/wakes_in_view.h"

namespace seaway::render {

/// Adds wake windows to a StampMap: a quad for each over the texels it meets, in which a shader
/// does what WakePyramid::addTo does, with the same coefficients.
class WakeStampPass {
 public:
  WakeStampPass();

  /// Draws `wakes` around the origin `foot` into the map that has begun, over `rows` of `columns`
  /// points, which must be bound. Needs an empty vertex array to be bound.
  void draw(const WakesInView& wakes, glm::dvec2 foot, std::span<const TwinRow> rows, int columns);

  std::size_t memoryBytes() const;

 private:
  /// One window's coefficients on the graphics card.
  struct Sheet {
    GlTexture spline, missing;
    int cells = 0, levels = 0;
  };
  static void upload(const WakePyramid& pyramid, Sheet& sheet);

  GlProgram program_;
  std::vector<Sheet> sheets_;
};

}  // namespace seaway::render
