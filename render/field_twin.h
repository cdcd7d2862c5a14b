#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "render/camera.h"
#include "render/projector.h"
#include "surface/field/wave_field.h"

namespace seaway::render {

/// One octave at one time as shaders read it (std140): coordinates from a local origin, their whole
/// cells folded into the seeds, so that single precision suffices wherever the origin lies.
/// `first.w` is metres per unit, `second.w` the dominant wavelength in m.
struct TwinOctave {
  glm::vec4 first{0.0f};   ///< group: along; Perlin: first; regular: turns
  glm::vec4 second{0.0f};  ///< group: across; Perlin: second
  glm::vec4 third{0.0f};   ///< group: turns; Perlin: weights of the slices before and after t
  glm::uvec4 seeds{0u};    ///< group: x, y; Perlin: x of both slices, y of both slices
};

/// A row of the projected grid as shaders read it (std430). All its points have the same
/// homogeneous coordinate, so that after the division its ends are enough.
struct TwinRow {
  glm::vec2 start{0.0f};        ///< first point relative to the origin, m
  glm::vec2 step{0.0f};         ///< to the next column, m
  float keptWavelength = 0.0f;  ///< see BandLimit::Plan
  float fadingWavelength = 0.0f;
  float weight = 0.0f;
  float missingSlope = 0.0f;

  /// Point of a column, with the shaders' own rounding.
  glm::vec2 point(int column) const;
};

/// Rows of a grid of `size` over `projector`'s range, with the band limit of each.
std::vector<TwinRow> twinRows(const Projector& projector, const WaveField& waves, glm::ivec2 size);

/// The wave field for shaders: what render/shaders/field.glsl needs of a WaveField at one time,
/// around one origin.
///
/// Positions are reduced in double here and are single precision from there on. Against
/// WaveField::sample heights differ by at most `heightBound`. On llvmpipe the shader gives the bits
/// of `sample`; on other renderers fused arithmetic stays within the same bound
/// (tests/render/field_twin_test.cpp).
class FieldTwin {
 public:
  /// Largest number of octaves that fit a uniform block of 64 KiB.
  static constexpr std::size_t mostOctaves = 1000;

  /// `origin` m, in the sea plane. Outside the place and time that the field serves there are no
  /// octaves: the sea is still. Throws InputError for a field of more than `mostOctaves`.
  FieldTwin(const WaveField& waves, double time, glm::dvec2 origin);

  /// Largest difference from WaveField::sample, m, within `reach` m of the origin and where
  /// WaveField::bound is small against it: coordinates of `reach` m carry two roundings of their
  /// own size, and a height changes by 2π of its peak a turn.
  static double heightBound(const WaveField& waves, double reach);

  /// Groups first, then Perlin octaves, then regular waves.
  std::span<const TwinOctave> octaves() const { return octaves_; }
  glm::ivec3 counts() const { return counts_; }

  /// Height (m) and slope at `point` m from the origin, of what a row carries: the shader's
  /// arithmetic in C++.
  glm::vec3 sample(glm::vec2 point, const TwinRow& row) const;

 private:
  std::vector<TwinOctave> octaves_;
  glm::ivec3 counts_{0};
};

}  // namespace seaway::render
