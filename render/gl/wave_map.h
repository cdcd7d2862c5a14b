#pragma once

#include <cstddef>
#include <span>

#include "render/camera.h"
#include "render/field_twin.h"
#include "render/gl/buffers.h"

namespace seaway::render {

/// The sea in projector space, computed by the graphics card: a texel for each vertex of the grid
/// with height (m), slope and the mean-square slope that its row does not carry (RGBA32F). Slopes
/// are the field's own derivatives, not differences between texels.
class WaveMap {
 public:
  /// Fragment shaders run everywhere; compute shaders are 26 times quicker on a data-centre card
  /// and no quicker in software. Both give the same texels where arithmetic is the same.
  enum class Way { fragment, compute };
  explicit WaveMap(Way way);

  /// Uploads rows ahead of `fill` and binds them, for stamps.
  void uploadRows(std::span<const TwinRow> rows);

  /// Fills the map for rows of `columns` points. `stamps`: a texture of the map's size that is
  /// added to it, 0 for none; `extras`: another. Needs an empty vertex array to be bound.
  void fill(const FieldTwin& field, std::span<const TwinRow> rows, int columns,
            const Camera& camera, GLuint stamps = 0, GLuint extras = 0);

  /// The program that fills the map: for what OutlineBuffers tells it.
  const GlProgram& program() const { return program_; }

  GLuint texture() const { return texture_; }
  glm::ivec2 size() const { return size_; }

  /// Binds what shaders read of the last `fill`: octaves, rows and the tally.
  void bindBuffers() const;

  /// What the last `fill` found; waits for the graphics card.
  struct Tally {
    float largestHeight = 0.0f;         ///< largest |height|, m
    std::size_t verticesInFrustum = 0;  ///< of the camera
  };
  Tally tally() const;

  std::size_t memoryBytes() const;

 private:
  void resize(glm::ivec2 size);
  void uploadField(const FieldTwin& field);

  Way way_;
  GlProgram program_;
  GlBuffer field_, tally_;
  GlGrowingBuffer rows_;
  GlTexture texture_;
  GlFramebuffer framebuffer_;
  glm::ivec2 size_{0};
};

/// Sets the uniforms of curved_sea.glsl.
void setCurvedSea(const GlProgram& program, const Camera& camera);

}  // namespace seaway::render
