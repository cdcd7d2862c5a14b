#include "tests/render/gl_census.h"

#include <glad/gl.h>

namespace seaway::render::test {
namespace {

std::map<std::string, long> counts;
long total = 0;

void note(const char* kind, long change) {
  counts[kind] += change;
  if (change > 0) total += change;
}

/// A function of the loader and what it was before.
#define SEAWAY_COUNTED_MAKER(Name, kind)                      \
  decltype(glad_gl##Name) before##Name = nullptr;             \
  void GLAD_API_PTR counted##Name(GLsizei n, GLuint* names) { \
    note(kind, n);                                            \
    before##Name(n, names);                                   \
  }
#define SEAWAY_COUNTED_DELETER(Name, kind)                              \
  decltype(glad_gl##Name) before##Name = nullptr;                       \
  void GLAD_API_PTR counted##Name(GLsizei n, const GLuint* names) {     \
    for (GLsizei i = 0; i < n; ++i) note(kind, names[i] != 0 ? -1 : 0); \
    before##Name(n, names);                                             \
  }
SEAWAY_COUNTED_MAKER(CreateBuffers, "buffer")
SEAWAY_COUNTED_MAKER(CreateVertexArrays, "vertex array")
SEAWAY_COUNTED_MAKER(CreateFramebuffers, "framebuffer")
SEAWAY_COUNTED_MAKER(GenTextures, "texture")
SEAWAY_COUNTED_DELETER(DeleteBuffers, "buffer")
SEAWAY_COUNTED_DELETER(DeleteVertexArrays, "vertex array")
SEAWAY_COUNTED_DELETER(DeleteFramebuffers, "framebuffer")
SEAWAY_COUNTED_DELETER(DeleteTextures, "texture")

decltype(glad_glCreateTextures) beforeCreateTextures = nullptr;
void GLAD_API_PTR countedCreateTextures(GLenum target, GLsizei n, GLuint* names) {
  note("texture", n);
  beforeCreateTextures(target, n, names);
}
decltype(glad_glCreateProgram) beforeCreateProgram = nullptr;
GLuint GLAD_API_PTR countedCreateProgram() {
  note("program", 1);
  return beforeCreateProgram();
}
decltype(glad_glDeleteProgram) beforeDeleteProgram = nullptr;
void GLAD_API_PTR countedDeleteProgram(GLuint name) {
  note("program", name != 0 ? -1 : 0);
  beforeDeleteProgram(name);
}
decltype(glad_glCreateShader) beforeCreateShader = nullptr;
GLuint GLAD_API_PTR countedCreateShader(GLenum kind) {
  note("shader", 1);
  return beforeCreateShader(kind);
}
decltype(glad_glDeleteShader) beforeDeleteShader = nullptr;
void GLAD_API_PTR countedDeleteShader(GLuint name) {
  note("shader", name != 0 ? -1 : 0);
  beforeDeleteShader(name);
}

#define SEAWAY_EVERY_COUNTED(Do)                                                         \
  Do(CreateBuffers) Do(CreateVertexArrays) Do(CreateFramebuffers) Do(GenTextures)        \
      Do(DeleteBuffers) Do(DeleteVertexArrays) Do(DeleteFramebuffers) Do(DeleteTextures) \
          Do(CreateTextures) Do(CreateProgram) Do(DeleteProgram) Do(CreateShader) Do(DeleteShader)

}  // namespace

GlCensus::GlCensus() {
  counts.clear();
  total = 0;
#define SEAWAY_STEP_IN(Name) before##Name = glad_gl##Name, glad_gl##Name = &counted##Name;
  SEAWAY_EVERY_COUNTED(SEAWAY_STEP_IN)
}

GlCensus::~GlCensus() {
#define SEAWAY_STEP_OUT(Name) glad_gl##Name = before##Name;
  SEAWAY_EVERY_COUNTED(SEAWAY_STEP_OUT)
}

std::map<std::string, long> GlCensus::alive() { return counts; }
long GlCensus::made() { return total; }

}  // namespace seaway::render::test
