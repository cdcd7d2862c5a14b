#pragma once

#include <cstddef>
#include <memory>

#include "render/gl/buffers.h"
#include "render/terrain/terrain_in_view.h"

namespace seaway::render {

/// Draws ground and sea bed into the geometry framebuffer, which must be bound.
class TerrainPass {
 public:
  TerrainPass();
  void draw(const TerrainInView& terrain, const Camera& camera,
            const glm::mat4& clipFromRelativeWorld);
  std::size_t memoryBytes() const { return vertices_.memoryBytes() + skinBytes_; }

 private:
  void upload(const TerrainSkin& skin);

  GlProgram program_;
  GlGrowingBuffer vertices_;
  GlVertexArray array_;
  const TerrainMap* map_ = nullptr;  // whose skin the textures hold
  GlTexture colours_, slopes_;
  std::size_t skinBytes_ = 0;
};

}  // namespace seaway::render
