#include "render/gl/gl_objects.h"

#include <glm/gtc/type_ptr.hpp>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "render/gl/loader.h"
#include "render/gl/shader_sources.h"

namespace seaway::render {
namespace {

std::string shaderLog(GLuint shader) {
  GLint length = 0;
  glGetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<std::size_t>(length), '\0');
  glGetShaderInfoLog(shader, length, nullptr, log.data());
  return log;
}

GLuint compile(GLenum stage, ShaderParts parts) {
  std::string text = "#version 450 core\n", names;
  text += isSoftwareRenderer() ? "#define exact precise\n" : "#define exact\n";
  for (const std::string_view part : parts) {
    text += shaderSource(part);
    names += std::string(part) + ' ';
  }
  const GLuint shader = glCreateShader(stage);
  const char* source = text.c_str();
  glShaderSource(shader, 1, &source, nullptr);
  glCompileShader(shader);
  GLint compiled = GL_FALSE;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  if (!compiled) {
    const std::string log = shaderLog(shader);
    glDeleteShader(shader);
    throw std::runtime_error("shader " + names + "does not compile: " + log);
  }
  return shader;
}

}  // namespace

GlBuffer makeBuffer() {
  GLuint name = 0;
  glCreateBuffers(1, &name);
  return GlBuffer(name);
}

GlVertexArray makeVertexArray() {
  GLuint name = 0;
  glCreateVertexArrays(1, &name);
  return GlVertexArray(name);
}

GlTexture makeTexture(GLenum format, glm::ivec2 size, GLenum filter, int levels) {
  GLuint name = 0;
  glCreateTextures(GL_TEXTURE_2D, 1, &name);
  GlTexture texture(name);
  glTextureStorage2D(name, levels, format, size.x, size.y);
  glTextureParameteri(name, GL_TEXTURE_MAG_FILTER, static_cast<GLint>(filter));
  glTextureParameteri(name, GL_TEXTURE_MIN_FILTER,
                      static_cast<GLint>(levels > 1 ? GL_LINEAR_MIPMAP_LINEAR : filter));
  glTextureParameteri(name, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTextureParameteri(name, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  return texture;
}

GlFramebuffer makeFramebuffer(std::initializer_list<GLuint> colours, GLuint depth) {
  GLuint name = 0;
  glCreateFramebuffers(1, &name);
  GlFramebuffer framebuffer(name);
  std::vector<GLenum> attachments;
  for (const GLuint colour : colours) {
    attachments.push_back(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(attachments.size()));
    glNamedFramebufferTexture(name, attachments.back(), colour, 0);
  }
  if (depth != 0) glNamedFramebufferTexture(name, GL_DEPTH_STENCIL_ATTACHMENT, depth, 0);
  glNamedFramebufferDrawBuffers(name, static_cast<GLsizei>(attachments.size()), attachments.data());
  if (glCheckNamedFramebufferStatus(name, GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    throw std::runtime_error("framebuffer is not complete");
  }
  return framebuffer;
}

GlProgram::GlProgram(ShaderParts vertex, ShaderParts fragment) : name_(glCreateProgram()) {
  const GLuint vertexShader = compile(GL_VERTEX_SHADER, vertex);
  glAttachShader(name_, vertexShader);
  glDeleteShader(vertexShader);  // the program keeps it
  const GLuint fragmentShader = compile(GL_FRAGMENT_SHADER, fragment);
  glAttachShader(name_, fragmentShader);
  glDeleteShader(fragmentShader);
  link();
}

GlProgram GlProgram::compute(ShaderParts parts) {
  GlProgram program;
  program.name_ = GlName<&releaseProgram>(glCreateProgram());
  const GLuint shader = compile(GL_COMPUTE_SHADER, parts);
  glAttachShader(program.name_, shader);
  glDeleteShader(shader);
  program.link();
  return program;
}

void GlProgram::link() {
  glLinkProgram(name_);
  GLint linked = GL_FALSE;
  glGetProgramiv(name_, GL_LINK_STATUS, &linked);
  if (!linked) {
    char log[2048] = "";
    glGetProgramInfoLog(name_, sizeof log, nullptr, log);
    throw std::runtime_error("shaders do not link: " + std::string(log));
  }
}

GLint GlProgram::location(const char* name) const {
  const auto known = locations_.find(std::string_view(name));
  if (known != locations_.end()) return known->second;
  return locations_.emplace(name, glGetUniformLocation(name_, name)).first->second;
}

void GlProgram::set(const char* name, int value) const {
  glProgramUniform1i(name_, location(name), value);
}
void GlProgram::set(const char* name, float value) const {
  glProgramUniform1f(name_, location(name), value);
}
void GlProgram::set(const char* name, glm::ivec2 value) const {
  glProgramUniform2iv(name_, location(name), 1, glm::value_ptr(value));
}
void GlProgram::set(const char* name, glm::vec2 value) const {
  glProgramUniform2fv(name_, location(name), 1, glm::value_ptr(value));
}
void GlProgram::set(const char* name, glm::vec3 value) const {
  glProgramUniform3fv(name_, location(name), 1, glm::value_ptr(value));
}
void GlProgram::set(const char* name, glm::vec4 value) const {
  glProgramUniform4fv(name_, location(name), 1, glm::value_ptr(value));
}
void GlProgram::set(const char* name, const glm::mat2& value) const {
  glProgramUniformMatrix2fv(name_, location(name), 1, GL_FALSE, glm::value_ptr(value));
}
void GlProgram::set(const char* name, const glm::mat3& value) const {
  glProgramUniformMatrix3fv(name_, location(name), 1, GL_FALSE, glm::value_ptr(value));
}
void GlProgram::set(const char* name, const glm::mat4& value) const {
  glProgramUniformMatrix4fv(name_, location(name), 1, GL_FALSE, glm::value_ptr(value));
}

void GlProgram::setTexture(const char* name, GLuint unit, GLuint texture) const {
  glBindTextureUnit(unit, texture);
  set(name, static_cast<int>(unit));
}

void checkGl(const char* place) {
  const GLenum error = glGetError();
  if (error == GL_NO_ERROR) return;
  std::ostringstream message;
  message << place << ": OpenGL error 0x" << std::hex << error;
  throw std::runtime_error(message.str());
}

}  // namespace seaway::render
