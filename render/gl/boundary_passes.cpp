#include "render/gl/boundary_passes.h"

#include <cmath>
#include <string>

#include "render/shore.h"
#include "surface/constants.h"

namespace seaway::render {
namespace {

void setRays(const GlProgram& program, const Camera& camera) {
  program.set("middleRay", glm::vec3(camera.middleRay()));
  program.set("right", glm::vec3(camera.rightHalf()));
  program.set("up", glm::vec3(camera.upperHalf()));
}

/// Draws over all pixels, whatever their depth, in the stencil class given.
void drawOver(const GlProgram& program, StencilClass which) {
  glDepthFunc(GL_ALWAYS);
  glStencilFunc(GL_ALWAYS, which, 0xFF);
  glUseProgram(program);
  // A fragment reads the texel it is about to write.
  glTextureBarrier();
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glTextureBarrier();
  glDepthFunc(GL_GREATER);
}

}  // namespace

GroundPass::GroundPass() : program_({"full_screen.vert"}, {"outline.glsl", "ground.frag"}) {}

void GroundPass::draw(const FrameTargets& targets, const View& view) {
  const Camera& camera = view.camera;
  setRays(program_, camera);
  program_.set("eyeHeight", static_cast<float>(camera.position.z));
  program_.set("curvature", static_cast<float>(0.5 / earthMeanRadius));
  program_.set("nearDistance", static_cast<float>(camera.nearDistance));
  program_.set("groundReflectance", groundReflectance);
  program_.setTexture("distanceMap", 0, targets.distance);
  outline_.use(program_, view.water->sharedOutline(), camera);
  drawOver(program_, stencilObject);
}

HullMaskPass::HullMaskPass() : program_({"full_screen.vert"}, {"hull_mask.frag"}) {}

void HullMaskPass::draw(const FrameTargets& targets, const Camera& camera,
                        std::span<const PlacedHollow> hollows) {
  setRays(program_, camera);
  program_.setTexture("distanceMap", 0, targets.distance);
  glColorMaski(0, GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  glColorMaski(1, GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  glEnable(GL_SCISSOR_TEST);
  for (const PlacedHollow& hollow : hollows) {
    const PixelBox box = pixelsOf(hollow, camera);
    const glm::ivec2 size = box.end - box.least;
    if (size.x <= 0 || size.y <= 0) continue;
    glScissor(box.least.x, targets.size.y - box.end.y, size.x, size.y);
    program_.set("planeCount", static_cast<int>(hollow.planes.size()));
    for (std::size_t i = 0; i < hollow.planes.size(); ++i) {
      program_.set(("planes[" + std::to_string(i) + "]").c_str(), hollow.planes[i]);
    }
    drawOver(program_, stencilSky);
  }
  glDisable(GL_SCISSOR_TEST);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

}  // namespace seaway::render
