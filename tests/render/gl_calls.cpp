#include "tests/render/gl_calls.h"

#include <glad/gl.h>

namespace seaway::render::test {
namespace {

long calls = 0;

template <auto Slot, class Function>
struct Counted;

template <auto Slot, class Result, class... Arguments>
struct Counted<Slot, Result(GLAD_API_PTR*)(Arguments...)> {
  static inline Result(GLAD_API_PTR* before)(Arguments...) = nullptr;

  static Result GLAD_API_PTR call(Arguments... arguments) {
    ++calls;
    return before(arguments...);
  }
  static void stepIn() {
    before = *Slot;
    if (before) *Slot = &call;
  }
  static void stepOut() { *Slot = before; }
};

// Those that render/ calls: a test compares.
#define SEAWAY_EVERY_GL_CALL(Do)                                                                   \
  Do(AttachShader) Do(BindBufferBase) Do(BindFramebuffer) Do(BindImageTexture) Do(                 \
      BindTextureUnit) Do(BindVertexArray) Do(BlendFunc) Do(CheckNamedFramebufferStatus)           \
      Do(ClearBufferfi) Do(ClearBufferfv) Do(ClipControl) Do(ColorMask) Do(ColorMaski) Do(         \
          CompileShader) Do(CreateBuffers) Do(CreateFramebuffers) Do(CreateProgram)                \
          Do(CreateQueries) Do(CreateShader) Do(CreateTextures) Do(CreateVertexArrays) Do(         \
              DeleteBuffers) Do(DeleteFramebuffers) Do(DeleteProgram) Do(DeleteQueries)            \
              Do(DeleteShader) Do(DeleteTextures) Do(DeleteVertexArrays) Do(DepthFunc) Do(         \
                  Disable) Do(DispatchCompute) Do(DrawArrays) Do(DrawArraysInstanced)              \
                  Do(DrawElements) Do(Enable) Do(EnableVertexArrayAttrib) Do(Finish) Do(           \
                      GenTextures) Do(GetError) Do(GetIntegerv) Do(GetNamedBufferSubData)          \
                      Do(GetProgramInfoLog) Do(GetProgramiv) Do(GetQueryObjectui64v) Do(           \
                          GetShaderInfoLog) Do(GetShaderiv) Do(GetString) Do(GetTextureImage)      \
                          Do(GetUniformLocation) Do(LinkProgram) Do(MemoryBarrier) Do(             \
                              NamedBufferData) Do(NamedBufferStorage) Do(NamedBufferSubData)       \
                              Do(NamedFramebufferDrawBuffers) Do(NamedFramebufferTexture)          \
                                  Do(PixelStorei) Do(ProgramUniform1f) Do(ProgramUniform1i) Do(    \
                                      ProgramUniform2fv) Do(ProgramUniform2iv)                     \
                                      Do(ProgramUniform3fv) Do(ProgramUniform4fv) Do(              \
                                          ProgramUniformMatrix2fv) Do(ProgramUniformMatrix3fv)     \
                                          Do(ProgramUniformMatrix4fv) Do(QueryCounter) Do(Scissor) \
                                              Do(ShaderSource) Do(StencilFunc) Do(StencilOp)       \
                                                  Do(TextureBarrier) Do(TextureParameteri) Do(     \
                                                      TextureStorage2D) Do(TextureStorage3D)       \
                                                      Do(TextureSubImage2D) Do(TextureSubImage3D)  \
                                                          Do(TextureView) Do(UseProgram) Do(       \
                                                              VertexArrayAttribBinding)            \
                                                              Do(VertexArrayAttribFormat) Do(      \
                                                                  VertexArrayBindingDivisor)       \
                                                                  Do(VertexArrayElementBuffer)     \
                                                                      Do(VertexArrayVertexBuffer)  \
                                                                          Do(Viewport)

}  // namespace

GlCalls::GlCalls() {
  calls = 0;
#define SEAWAY_STEP_IN(Name) Counted<&glad_gl##Name, decltype(glad_gl##Name)>::stepIn();
  SEAWAY_EVERY_GL_CALL(SEAWAY_STEP_IN)
}

GlCalls::~GlCalls() {
#define SEAWAY_STEP_OUT(Name) Counted<&glad_gl##Name, decltype(glad_gl##Name)>::stepOut();
  SEAWAY_EVERY_GL_CALL(SEAWAY_STEP_OUT)
}

long GlCalls::count() { return calls; }

std::vector<std::string_view> GlCalls::counted() {
#define SEAWAY_NAME(Name) "gl" #Name,
  return {SEAWAY_EVERY_GL_CALL(SEAWAY_NAME)};
}

}  // namespace seaway::render::test
