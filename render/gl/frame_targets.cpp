#include "render/gl/frame_targets.h"

#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <limits>
#include <vector>

namespace seaway::render {

FrameTargets::FrameTargets(glm::ivec2 imageSize)
    : size(imageSize),
      surface(makeTexture(GL_RGBA16F, size, GL_NEAREST)),
      albedo(makeTexture(GL_RGBA8, size, GL_NEAREST)),
      distance(makeTexture(GL_R32F, size, GL_NEAREST)),
      depth(makeTexture(GL_DEPTH32F_STENCIL8, size, GL_NEAREST)),
      radiance(makeTexture(GL_RGBA16F, size, GL_NEAREST)),
      display(makeTexture(GL_SRGB8_ALPHA8, size, GL_NEAREST)),
      geometry(makeFramebuffer({surface, albedo, distance}, depth)),
      shading(makeFramebuffer({radiance}, depth)),
      toneMapping(makeFramebuffer({display})) {}

GLuint FrameTargets::displayBytes() {
  if (displayBytes_ == 0) {
    GLuint name = 0;
    glGenTextures(1, &name);
    displayBytes_ = GlTexture(name);
    glTextureView(name, GL_TEXTURE_2D, display, GL_RGBA8, 0, 1, 0, 1);
  }
  return displayBytes_;
}

std::size_t FrameTargets::memoryBytes() const {
  return static_cast<std::size_t>(size.x) * size.y * (8 + 4 + 4 + 8 + 8 + 4);
}

namespace {

void readNormals(const FrameTargets& targets, Frame& frame) {
  const glm::ivec2 size = targets.size;
  std::vector<glm::vec4> surface(frame.normals.size());  // bottom row first
  glGetTextureImage(targets.surface, 0, GL_RGBA, GL_FLOAT,
                    static_cast<GLsizei>(surface.size() * sizeof(glm::vec4)), surface.data());
  for (int y = 0; y < size.y; ++y) {
    const glm::vec4* from = surface.data() + static_cast<std::size_t>(size.y - 1 - y) * size.x;
    for (int x = 0; x < size.x; ++x) {
      const std::size_t to = static_cast<std::size_t>(y) * size.x + x;
      frame.normals[to] = frame.classes[to] == PixelClass::water
                              ? glm::normalize(glm::vec3(-from[x].x, -from[x].y, 1.0f))
                          : frame.classes[to] == PixelClass::sky ? glm::vec3(0.0f)
                                                                 : glm::vec3(from[x]);
    }
  }
}

void markGround(const FrameTargets& targets, Frame& frame) {
  const glm::ivec2 size = targets.size;
  std::vector<std::uint8_t> albedo(4 * frame.classes.size());  // bottom row first
  glGetTextureImage(targets.albedo, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                    static_cast<GLsizei>(albedo.size()), albedo.data());
  for (std::size_t i = 0; i < frame.classes.size(); ++i) {
    const std::size_t x = i % size.x, y = size.y - 1 - i / size.x;
    if (frame.classes[i] == PixelClass::object && albedo[4 * (y * size.x + x) + 3] == 0) {
      frame.classes[i] = PixelClass::ground;
    }
  }
}

}  // namespace

void readBack(const FrameTargets& targets, bool groundIsShown, Frame& frame) {
  const glm::ivec2 size = targets.size;
  const std::size_t pixels = static_cast<std::size_t>(size.x) * size.y;
  std::vector<std::uint8_t> rgba(4 * pixels);
  glGetTextureImage(targets.display, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                    static_cast<GLsizei>(rgba.size()), rgba.data());
  for (std::size_t i = 0; i < pixels; ++i) {
    for (std::size_t c = 0; c < 3; ++c) frame.colour.rgb[3 * i + c] = rgba[4 * i + c];
  }

  std::vector<float> signedDistance(pixels);  // bottom row first
  glGetTextureImage(targets.distance, 0, GL_RED, GL_FLOAT,
                    static_cast<GLsizei>(pixels * sizeof(float)), signedDistance.data());
  for (int y = 0; y < size.y; ++y) {
    const float* from = signedDistance.data() + static_cast<std::size_t>(size.y - 1 - y) * size.x;
    const std::size_t to = static_cast<std::size_t>(y) * size.x;
    for (int x = 0; x < size.x; ++x) {
      const float distance = from[x];
      frame.depth.metres[to + x] =
          distance == 0.0f ? std::numeric_limits<float>::infinity() : std::abs(distance);
      frame.classes[to + x] = distance == 0.0f  ? PixelClass::sky
                              : distance > 0.0f ? PixelClass::water
                                                : PixelClass::object;
    }
  }
  if (groundIsShown) markGround(targets, frame);
  if (!frame.normals.empty()) readNormals(targets, frame);
}

}  // namespace seaway::render