#include "render/gl/loader.h"

#include <glad/gl.h>

#include <algorithm>
#include <stdexcept>

namespace seaway::render {
namespace {

std::string text(GLenum name) {
  const GLubyte* found = glGetString(name);
  return found ? reinterpret_cast<const char*>(found) : "";
}

/// Renderers of Mesa that run on the processor.
bool namesSoftware(const std::string& renderer) {
  for (const char* name : {"llvmpipe", "softpipe", "swrast", "Software Rasterizer"}) {
    if (renderer.find(name) != std::string::npos) return true;
  }
  return false;
}

}  // namespace

void loadGl(GlGetProcedure getProcedure) {
  const int version = gladLoadGL(getProcedure);
  if (version == 0) throw std::runtime_error("OpenGL functions cannot be loaded");
  if (version < GLAD_MAKE_VERSION(4, 5)) {
    throw std::runtime_error("OpenGL 4.5 core is needed; the context has " + text(GL_VERSION));
  }
}

bool isSoftwareRenderer() { return namesSoftware(text(GL_RENDERER)); }

GlDescription describeGl() {
  GLint texture = 0, renderbuffer = 0, viewport[2] = {0, 0};
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &texture);
  glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &renderbuffer);
  glGetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport);
  const std::string renderer = text(GL_RENDERER);
  return {renderer, text(GL_VERSION), std::min({texture, renderbuffer, viewport[0], viewport[1]}),
          namesSoftware(renderer)};
}

}  // namespace seaway::render
