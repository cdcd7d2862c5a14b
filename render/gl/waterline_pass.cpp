#include "render/gl/waterline_pass.h"

namespace seaway::render {

WaterlinePass::WaterlinePass()
    : program_({"full_screen.vert"}, {"waterline.frag"}),
      texture_(makeTexture(GL_R32F, {Waterline::cells + 1, Waterline::cells + 1}, GL_NEAREST)) {}

void WaterlinePass::draw(const FrameTargets& targets, const Waterline& waterline) {
  constexpr int side = Waterline::cells + 1;
  glTextureSubImage2D(texture_, 0, 0, 0, side, side, GL_RED, GL_FLOAT, waterline.heights().data());
  program_.setTexture("waterlineMap", 0, texture_);
  program_.set("perPixel", waterline.perPixel());
  program_.set("height", targets.size.y);
  static_assert(stencilUnderside == stencilWater + 1);
  glDisable(GL_DEPTH_TEST);
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  glStencilFunc(GL_EQUAL, stencilWater, 0xFF);
  glStencilOp(GL_KEEP, GL_KEEP, GL_INCR);
  glUseProgram(program_);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glEnable(GL_DEPTH_TEST);
}

}  // namespace seaway::render
