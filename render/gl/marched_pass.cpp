#include "render/gl/marched_pass.h"

#include <cmath>

namespace seaway::render {

MarchedPass::MarchedPass()
    : march_(GlProgram::compute(
          {"field_buffers.glsl", "field.glsl", "curved_sea.glsl", "outline.glsl", "march.comp"})),
      depth_({"full_screen.vert"}, {"march_depth.frag"}),
      noVertices_(makeVertexArray()) {}

std::string_view MarchedPass::variant() const { return gridVariantName(GridVariant::marched); }

SeaPlacement MarchedPass::place(const View& view, const Projector& projector, glm::ivec2 size) {
  waves_.fill(view, projector, size);
  const Camera& camera = view.camera;
  nearDistance_ = static_cast<float>(camera.nearDistance);
  setCurvedSea(march_, camera);
  waves_.useOutline(march_, view);
  march_.set("middleRay", glm::vec3(camera.middleRay()));
  march_.set("right", glm::vec3(camera.rightHalf()));
  march_.set("up", glm::vec3(camera.upperHalf()));
  march_.set("nearDistance", nearDistance_);
  const WaveMap::Tally tally = waves_.map().tally();
  return {tally.largestHeight, static_cast<std::size_t>(size.x) * size.y, tally.verticesInFrustum};
}

void MarchedPass::draw(const FrameTargets& targets, const glm::mat4&, bool cameraIsUnderWater) {
  waves_.map().bindBuffers();
  march_.setTexture("waveMap", 0, waves_.map().texture());
  march_.setTexture("stamps", 1, waves_.stamps());
  march_.set("stampsAreOn", waves_.stamps() != 0 ? 1 : 0);
  march_.set("extrasAreOn", waves_.extras() != 0 ? 1 : 0);
  if (waves_.extras() != 0) march_.setTexture("extras", 3, waves_.extras());
  waves_.useCover(march_);
  glUseProgram(march_);
  glBindImageTexture(2, targets.albedo, 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA8);
  glBindImageTexture(0, targets.surface, 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA16F);
  glBindImageTexture(1, targets.distance, 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_R32F);
  glMemoryBarrier(GL_FRAMEBUFFER_BARRIER_BIT);  // the targets were cleared by drawing
  glDispatchCompute(static_cast<GLuint>((targets.size.x + 15) / 16),
                    static_cast<GLuint>((targets.size.y + 7) / 8), 1);
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT);

  // The depth pass reads a texture of the framebuffer it draws to.
  glTextureBarrier();
  depth_.set("nearDistance", nearDistance_);
  depth_.setTexture("distanceMap", 0, targets.distance);
  glStencilFunc(GL_ALWAYS, cameraIsUnderWater ? stencilUnderside : stencilWater, 0xFF);
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  glUseProgram(depth_);
  glBindVertexArray(noVertices_);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

std::size_t MarchedPass::memoryBytes() const { return waves_.memoryBytes(); }

}  // namespace seaway::render
