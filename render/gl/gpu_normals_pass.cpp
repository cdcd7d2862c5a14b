#include "render/gl/gpu_normals_pass.h"

#include <cstddef>

#include "render/surf.h"

namespace seaway::render {

GpuNormalsPass::GpuNormalsPass()
    : program_({"sea_mapped.vert"}, {"sea_mapped.frag"}), array_(makeVertexArray()) {
  glVertexArrayVertexBuffer(array_, 0, vertices_, 0, sizeof(SeaVertex));
  glVertexArrayElementBuffer(array_, indices_);
  floatAttribute(array_, 0, 3, offsetof(SeaVertex, position));
}

std::string_view GpuNormalsPass::variant() const {
  return gridVariantName(GridVariant::cpuVerticesGpuNormals);
}

SeaPlacement GpuNormalsPass::place(const View& view, const Projector& projector, glm::ivec2 size) {
  vertexCount_ = size / 8 + 1;
  const std::optional<Surf> surf = surfOf(view);
  grid_.fill(view.water->at(view.time), view.camera,
             projectedLayout(projector, view.water->waves(), vertexCount_), 0.0,
             surf ? &*surf : nullptr);
  mesh_.fill(grid_, view.camera);
  waves_.fill(view, projector, size);
  return {grid_.largestHeight(), grid_.vertexCount(), grid_.verticesInFrustum(view.camera)};
}

void GpuNormalsPass::draw(const FrameTargets&, const glm::mat4& clipFromRelativeWorld,
                          bool cameraIsUnderWater) {
  if (mesh_.indices().empty()) return;
  vertices_.put(std::span(mesh_.vertices()));
  indices_.put(std::span(mesh_.indices()));
  program_.set("clipFromRelativeWorld", clipFromRelativeWorld);
  program_.set("vertices", vertexCount_);
  program_.setTexture("waveMap", 0, waves_.map().texture());
  waves_.useCover(program_);
  setWaterStencil(cameraIsUnderWater);
  glUseProgram(program_);
  glBindVertexArray(array_);
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(mesh_.indices().size()), GL_UNSIGNED_INT,
                 nullptr);
}

std::size_t GpuNormalsPass::memoryBytes() const {
  return grid_.memoryBytes() + mesh_.memoryBytes() + vertices_.memoryBytes() +
         indices_.memoryBytes() + waves_.memoryBytes();
}

}  // namespace seaway::render
