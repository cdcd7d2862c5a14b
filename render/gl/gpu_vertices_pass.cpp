#include "render/gl/gpu_vertices_pass.h"

namespace seaway::render {

GpuVerticesPass::GpuVerticesPass()
    : program_({"field_buffers.glsl", "curved_sea.glsl", "sea_mesh.vert"}, {"water.frag"}),
      array_(makeVertexArray()) {}

std::string_view GpuVerticesPass::variant() const { return gridVariantName(GridVariant::gpu); }

SeaPlacement GpuVerticesPass::place(const View& view, const Projector& projector, glm::ivec2 size) {
  waves_.fill(view, projector, size);
  setCurvedSea(program_, view.camera);
  const WaveMap::Tally tally = waves_.map().tally();
  return {tally.largestHeight, static_cast<std::size_t>(size.x) * size.y, tally.verticesInFrustum};
}

void GpuVerticesPass::draw(const FrameTargets&, const glm::mat4& clipFromRelativeWorld,
                           bool cameraIsUnderWater) {
  const glm::ivec2 size = waves_.map().size();
  if (size.x < 2 || size.y < 2) return;
  indices_.prepare(size);
  glVertexArrayElementBuffer(array_, indices_.buffer());
  waves_.map().bindBuffers();
  program_.set("clipFromRelativeWorld", clipFromRelativeWorld);
  program_.setTexture("waveMap", 0, waves_.map().texture());
  waves_.useCover(program_);
  setWaterStencil(cameraIsUnderWater);
  glUseProgram(program_);
  glBindVertexArray(array_);
  glDrawElements(GL_TRIANGLES, indices_.count(), GL_UNSIGNED_INT, nullptr);
}

std::size_t GpuVerticesPass::memoryBytes() const {
  return waves_.memoryBytes() + indices_.memoryBytes();
}

}  // namespace seaway::render
