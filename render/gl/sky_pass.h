#pragma once

#include <cstddef>
#include <optional>

#include "render/gl/gl_objects.h"

namespace seaway::render {

/// The sky as a map of directions, for the picture, for mirroring and for ambient light; drawn when
/// the light changes. Needs an empty vertex array to be bound.
class SkyPass {
 public:
  SkyPass();
  void draw(glm::vec3 sunDirection);
  GLuint dome() const { return dome_; }
  std::size_t memoryBytes() const;

 private:
  GlProgram program_;
  GlTexture dome_;
  GlFramebuffer framebuffer_;
  std::optional<glm::vec3> drawnFor_;
};

}  // namespace seaway::render
