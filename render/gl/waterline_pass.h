#pragma once

#include "render/gl/frame_targets.h"
#include "render/waterline.h"

namespace seaway::render {

/// Tells the pixels of water that are under it from those above, where the surface cuts the view:
/// those get stencilUnderside. The sea must have been drawn, nothing else, into the geometry
/// framebuffer, which is bound. Needs an empty vertex array to be bound.
class WaterlinePass {
 public:
  WaterlinePass();
  void draw(const FrameTargets& targets, const Waterline& waterline);
  GLuint texture() const { return texture_; }

 private:
  GlProgram program_;
  GlTexture texture_;
};

}  // namespace seaway::render
