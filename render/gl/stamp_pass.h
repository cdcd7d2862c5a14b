#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <span>
#include <string_view>

#include "render/field_twin.h"
#include "render/gl/buffers.h"

namespace seaway::render {

/// A local disturbance of the surface that is added to the wave map: an oriented rectangle of the
/// sea plane in which a shader gives height and slope.
struct Stamp {
  glm::dvec2 centre{0.0};    ///< m, sea plane
  double toward = 0.0;       ///< direction of its first axis, rad counter-clockwise from east
  glm::dvec2 halfSize{1.0};  ///< m along its axes, > 0
  double height = 0.0;       ///< m per unit of the shader's height
};

/// Adds stamps to a StampMap.
///
/// Made when a scene first has a stamp. Each stamp costs its texels only; a row that is too coarse
/// for it, as for waves of four times its shorter half size, fades it out.
class StampPass {
 public:
  /// `shape` names an embedded shader that defines `vec3 stampShape(vec2 local)`: height and its
  /// derivatives by `local`, which runs over [-1, 1]² along the stamp's axes; 0 at the edge.
  explicit StampPass(std::string_view shape = "stamp_bump.glsl");

  /// Draws `stamps` around the origin `foot` into the map that has begun, over `rows` of `columns`
  /// points, which must be bound (WaveMap::uploadRows). Leaves its own vertex array bound.
  void draw(std::span<const Stamp> stamps, glm::dvec2 foot, std::span<const TwinRow> rows,
            int columns);

  std::size_t memoryBytes() const { return instances_.memoryBytes(); }

 private:
  GlProgram program_;
  GlGrowingBuffer instances_;
  GlVertexArray array_;
};

}  // namespace seaway::render
