#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "render/field_twin.h"
#include "render/gl/gl_objects.h"
#include "render/render_technique.h"

namespace seaway::render {

class Surf;

/// What the processor adds to the wave map: what lies on the water, and what disturbs it beside
/// waves and wakes, at the grid's vertices. Textures of the map's size, made when first called for.
class CoverMap {
 public:
  /// Works out both for a grid of `rows` of `columns` points about the camera's foot. Where nothing
  /// is called for this does nothing.
  void fill(const View& view, std::span<const TwinRow> rows, int columns);

  /// Foam, smoothed water and oil, RGBA8; 0 where nothing lies on the water.
  GLuint cover() const { return coverIsOn_ ? cover_ : 0; }
  /// Height, slope and 0 to be added, RGBA32F: splashes, ripples, short waves that are damped; 0
  /// where there are none.
  GLuint extras() const { return extrasAreOn_ ? extras_ : 0; }

  std::size_t memoryBytes() const;

 private:
  void resize(glm::ivec2 size);
  void fillRow(const SurfaceAtTime& water, glm::dvec2 foot, const TwinRow& row, const Surf* surf,
               int index);

  glm::ivec2 size_{0};
  GlTexture cover_, extras_;
  std::vector<std::uint32_t> covers_;
  std::vector<glm::vec4> added_;
  bool coverIsOn_ = false, extrasAreOn_ = false;
};

}  // namespace seaway::render
