#pragma once

#include "render/gl/projected_waves.h"
#include "render/gl/sea_mesh.h"

namespace seaway::render {

/// A coarse mesh from the processor, an eighth of the grid each way, with slopes from the graphics
/// card at every point of the grid (Johanson 2004: 65 × 129 vertices, 512 × 1024 normals). What the
/// coarse mesh cannot carry still shows in shading, though not in the outline of the waves.
class GpuNormalsPass final : public SeaGeometryPass {
 public:
  GpuNormalsPass();
  std::string_view variant() const override;
  SeaPlacement place(const View& view, const Projector& projector, glm::ivec2 size) override;
  void draw(const FrameTargets& targets, const glm::mat4& clipFromRelativeWorld,
            bool cameraIsUnderWater) override;
  std::vector<std::pair<std::string, double>> gpuMs() override { return waves_.gpuMs(); }
  std::size_t memoryBytes() const override;

 private:
  GlProgram program_;
  GlGrowingBuffer vertices_, indices_;
  GlVertexArray array_;
  ProjectedWaves waves_;
  SeaGrid grid_;
  SeaMesh mesh_;
  glm::ivec2 vertexCount_{0};
};

}  // namespace seaway::render
