#include "render/gl/sky_pass.h"

namespace seaway::render {
namespace {

// Fine enough to be looked at: 4 mrad a texel at the horizon, where a pixel of a 60° camera with
// 720 rows has 1.5 and the clouds have none finer than 10.
constexpr int side = 512, levels = 10;

}  // namespace

SkyPass::SkyPass()
    : program_({"full_screen.vert"}, {"atmosphere.glsl", "sky_dome.frag"}),
      dome_(makeTexture(GL_RGBA32F, {side, side}, GL_LINEAR, levels)),
      framebuffer_(makeFramebuffer({dome_})) {}

void SkyPass::draw(glm::vec3 sunDirection) {
  if (drawnFor_ == sunDirection) return;
  program_.set("sunDirection", sunDirection);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  glViewport(0, 0, side, side);
  glUseProgram(program_);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glGenerateTextureMipmap(dome_);
  drawnFor_ = sunDirection;
}

std::size_t SkyPass::memoryBytes() const { return std::size_t{side} * side * 16 * 4 / 3; }

}  // namespace seaway::render
