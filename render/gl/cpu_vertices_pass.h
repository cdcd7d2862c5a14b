#pragma once

#include "render/gl/buffers.h"
#include "render/gl/sea_geometry_pass.h"
#include "render/gl/sea_mesh.h"

namespace seaway::render {

/// Vertices from the processor, drawn as a mesh through GL.
class CpuVerticesPass final : public SeaGeometryPass {
 public:
  CpuVerticesPass();
  std::string_view variant() const override;
  SeaPlacement place(const View& view, const Projector& projector, glm::ivec2 size) override;
  void draw(const FrameTargets& targets, const glm::mat4& clipFromRelativeWorld,
            bool cameraIsUnderWater) override;
  std::size_t memoryBytes() const override;

 private:
  SeaGrid grid_;
  SeaMesh mesh_;
  GlProgram program_;
  GlGrowingBuffer vertices_, indices_;
  GlVertexArray array_;
};

}  // namespace seaway::render
