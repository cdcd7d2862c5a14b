#include "render/gl/water_pass.h"

#include <cstddef>

#include "render/gl/frame_targets.h"

namespace seaway::render {

WaterPass::WaterPass() : program_({"water.vert"}, {"water.frag"}), array_(makeVertexArray()) {
  glVertexArrayVertexBuffer(array_, 0, vertices_, 0, sizeof(SeaVertex));
  glVertexArrayElementBuffer(array_, indices_);
  floatAttribute(array_, 0, 3, offsetof(SeaVertex, position));
  floatAttribute(array_, 1, 2, offsetof(SeaVertex, slope));
  floatAttribute(array_, 2, 2, offsetof(SeaVertex, height));
}

void WaterPass::draw(const SeaGrid& grid, const glm::mat4& clipFromRelativeWorld,
                     bool cameraIsUnderWater) {
  if (grid.indices().empty()) return;
  vertices_.put(std::span(grid.vertices()));
  indices_.put(std::span(grid.indices()));
  program_.set("clipFromRelativeWorld", clipFromRelativeWorld);
  glStencilFuncSeparate(GL_FRONT, GL_ALWAYS, stencilWater, 0xFF);
  // From above, a back side that shows is a crest's rim within a pixel, not the underside.
  glStencilFuncSeparate(GL_BACK, GL_ALWAYS, cameraIsUnderWater ? stencilUnderside : stencilWater,
                        0xFF);
  glUseProgram(program_);
  glBindVertexArray(array_);
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(grid.indices().size()), GL_UNSIGNED_INT,
                 nullptr);
}

}  // namespace seaway::render
