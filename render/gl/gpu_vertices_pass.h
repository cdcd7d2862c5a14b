#pragma once

#include "render/gl/grid_indices.h"
#include "render/gl/projected_waves.h"

namespace seaway::render {

/// Heights and slopes from the graphics card, vertices displaced by texture fetch (Johanson 2004,
/// "GPU-based" variant). Nothing is read back but the tally.
class GpuVerticesPass final : public SeaGeometryPass {
 public:
  GpuVerticesPass();
  std::string_view variant() const override;
  SeaPlacement place(const View& view, const Projector& projector, glm::ivec2 size) override;
  void draw(const FrameTargets& targets, const glm::mat4& clipFromRelativeWorld,
            bool cameraIsUnderWater) override;
  std::vector<std::pair<std::string, double>> gpuMs() override { return waves_.gpuMs(); }
  std::size_t memoryBytes() const override;

 private:
  GlProgram program_;
  GlVertexArray array_;
  ProjectedWaves waves_;
  GridIndices indices_;
};

}  // namespace seaway::render
