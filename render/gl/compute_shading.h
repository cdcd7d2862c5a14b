#pragma once

#include "render/gl/shading_pass.h"

namespace seaway::render {

/// Shading and tone mapping in one compute shader, with the same text and textures as ShadingPass:
/// for data-centre cards, whose fragment shaders are slow. Where the camera is under water all of
/// the surface counts as seen from below.
class ComputeShading {
 public:
  ComputeShading();
  /// From `geometry` to `display`, and to `radiance` where that is wanted.
  void shade(FrameTargets& targets, const ShadingInput& input, bool wantsRadiance);

  std::size_t skyMemoryBytes() const { return textures_.skyMemoryBytes(); }
  std::size_t waterMemoryBytes() const { return textures_.waterMemoryBytes(); }

 private:
  GlProgram program_;
  ShadingTextures textures_;
};

}  // namespace seaway::render
