#pragma once

#include <memory>

#include "render/camera.h"
#include "render/gl/buffers.h"
#include "surface/outline/water_outline.h"

namespace seaway::render {

/// An outline's index on the graphics card, for shaders/outline.glsl. Makes nothing until there is
/// an outline.
class OutlineBuffers {
 public:
  /// Uploads the outline where it is another one, binds the buffers and sets the uniforms of
  /// `program`; null: tells the program that there is none.
  void use(const GlProgram& program, const std::shared_ptr<const WaterOutline>& outline,
           const Camera& camera);
  std::size_t memoryBytes() const;

 private:
  struct Buffers {
    GlGrowingBuffer cells, edges;
  };
  void upload();

  std::unique_ptr<Buffers> buffers_;
  std::shared_ptr<const WaterOutline> outline_;
};

}  // namespace seaway::render
