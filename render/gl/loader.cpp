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

}  // namespace

GlDescription loadGl(GlGetProcedure getProcedure) {
  const int version = gladLoadGL(getProcedure);
  if (version == 0) throw std::runtime_error("OpenGL functions cannot be loaded");
  if (version < GLAD_MAKE_VERSION(4, 5)) {
    throw std::runtime_error("OpenGL 4.5 core is needed; the context has " + text(GL_VERSION));
  }
  GLint texture = 0, renderbuffer = 0, viewport[2] = {0, 0};
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &texture);
  glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &renderbuffer);
  glGetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport);
  return {text(GL_RENDERER), text(GL_VERSION),
          std::min({texture, renderbuffer, viewport[0], viewport[1]})};
}

}  // namespace seaway::render
