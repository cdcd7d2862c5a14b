#include "render/gl/cpu_vertices_pass.h"

#include <cstddef>

#include "render/surf.h"

namespace seaway::render {

CpuVerticesPass::CpuVerticesPass()
    : program_({"water.vert"}, {"water.frag"}), array_(makeVertexArray()) {
  glVertexArrayVertexBuffer(array_, 0, vertices_, 0, sizeof(SeaVertex));
  glVertexArrayElementBuffer(array_, indices_);
  floatAttribute(array_, 0, 3, offsetof(SeaVertex, position));
  floatAttribute(array_, 1, 2, offsetof(SeaVertex, slope));
  floatAttribute(array_, 2, 2, offsetof(SeaVertex, height));
  byteAttribute(array_, 3, offsetof(SeaVertex, cover));
}

std::string_view CpuVerticesPass::variant() const {
  return gridVariantName(GridVariant::cpuVertices);
}

SeaPlacement CpuVerticesPass::place(const View& view, const Projector& projector, glm::ivec2 size) {
  const std::optional<Surf> surf = surfOf(view);
  grid_.fill(view.water->at(view.time), view.camera,
             projectedLayout(projector, view.water->waves(), size), 0.0, surf ? &*surf : nullptr);
  mesh_.fill(grid_, view.camera);
  return {grid_.largestHeight(), grid_.vertexCount(), grid_.verticesInFrustum(view.camera)};
}

void CpuVerticesPass::draw(const FrameTargets&, const glm::mat4& clipFromRelativeWorld,
                           bool cameraIsUnderWater) {
  if (mesh_.indices().empty()) return;
  vertices_.put(std::span(mesh_.vertices()));
  indices_.put(std::span(mesh_.indices()));
  program_.set("clipFromRelativeWorld", clipFromRelativeWorld);
  setWaterStencil(cameraIsUnderWater);
  glUseProgram(program_);
  glBindVertexArray(array_);
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(mesh_.indices().size()), GL_UNSIGNED_INT,
                 nullptr);
}

std::size_t CpuVerticesPass::memoryBytes() const {
  return grid_.memoryBytes() + mesh_.memoryBytes() + vertices_.memoryBytes() +
         indices_.memoryBytes();
}

}  // namespace seaway::render
