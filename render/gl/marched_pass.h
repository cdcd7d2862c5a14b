#pragma once

#include "render/gl/projected_waves.h"

namespace seaway::render {

/// The surface without a mesh: a compute shader marches each pixel's ray over the wave map, from
/// row to row, and meets the field itself by one step of Newton's method, with the rows' band
/// limit. The way for data-centre cards, whose arithmetic is quick in compute shaders alone.
class MarchedPass final : public SeaGeometryPass {
 public:
  MarchedPass();
  std::string_view variant() const override;
  SeaPlacement place(const View& view, const Projector& projector, glm::ivec2 size) override;
  void draw(const FrameTargets& targets, const glm::mat4& clipFromRelativeWorld,
            bool cameraIsUnderWater) override;
  std::vector<std::pair<std::string, double>> gpuMs() override { return waves_.gpuMs(); }
  std::size_t memoryBytes() const override;

 private:
  GlProgram march_, depth_;
  GlVertexArray noVertices_;
  ProjectedWaves waves_;
  float nearDistance_ = 0.0f;
};

}  // namespace seaway::render
