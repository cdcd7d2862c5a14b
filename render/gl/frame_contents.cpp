#include <tbb/parallel_for.h>

#include <algorithm>
#include <string>

#include "render/gl/frame_targets.h"
#include "render/gl/object_pass.h"
#include "render/shading/pixel_shader.h"
#include "surface/input_error.h"

namespace seaway::render {
namespace {

template <typename Texel>
std::vector<Texel> texelsOf(GLuint texture, glm::ivec2 size, GLenum type) {
  std::vector<Texel> texels(static_cast<std::size_t>(size.x) * size.y);  // bottom row first
  glGetTextureImage(texture, 0, GL_RGBA, type, static_cast<GLsizei>(texels.size() * sizeof(Texel)),
                    texels.data());
  return texels;
}

using Albedo = glm::vec<4, std::uint8_t>;

void readRadiance(const FrameTargets& targets, Frame& frame) {
  const glm::ivec2 size = targets.size;
  const auto texels = texelsOf<glm::vec4>(targets.radiance, size, GL_FLOAT);
  for (int y = 0; y < size.y; ++y) {
    const glm::vec4* from = texels.data() + static_cast<std::size_t>(size.y - 1 - y) * size.x;
    glm::vec3* to = frame.radiance.data() + static_cast<std::size_t>(y) * size.x;
    for (int x = 0; x < size.x; ++x) to[x] = glm::vec3(from[x]);
  }
}

/// A row of water as it was shaded.
void fillSpan(const glm::vec4* surface, const Albedo* cover, const Frame& frame, std::size_t at,
              PixelSpan& span) {
  span.hasCover = true;
  for (int i = 0; i < span.count; ++i) {
    const bool isWater = frame.classes[at + i] == PixelClass::water;
    span.kind[i] = isWater ? ShadedAs::water : ShadedAs::sky;
    span.axial[i] = isWater ? frame.depth.metres[at + i] : 1.0f;
    span.slopeX[i] = surface[i].x;
    span.slopeY[i] = surface[i].y;
    span.missingSlope[i] = surface[i].z;
    span.height[i] = surface[i].w;
    for (int c = 0; c < 3; ++c) span.cover[c][i] = static_cast<float>(cover[i][c]) / 255.0f;
  }
}

void readFoam(const FrameTargets& targets, const std::vector<Albedo>& albedo,
              const ShadingConstants& constants, Frame& frame) {
  if (!constants.foamIsOn || constants.cameraIsUnderWater) {
    std::fill(frame.foam.begin(), frame.foam.end(), std::uint8_t{0});
    return;
  }
  const glm::ivec2 size = targets.size;
  const auto surface = texelsOf<glm::vec4>(targets.surface, size, GL_FLOAT);
  const glm::vec2 perPixel = 2.0f / glm::vec2(size);
  tbb::parallel_for(0, size.y, [&](int y) {
    PixelSpan span{};
    alignas(64) float white[pixelsPerSpan + 16];
    for (int first = 0; first < size.x; first += pixelsPerSpan) {
      span.count = std::min(pixelsPerSpan, size.x - first);
      const std::size_t at = static_cast<std::size_t>(y) * size.x + first;
      const std::size_t from = static_cast<std::size_t>(size.y - 1 - y) * size.x + first;
      fillSpan(&surface[from], &albedo[from], frame, at, span);
      const float across = (static_cast<float>(first) + 0.5f) * perPixel.x - 1.0f;
      const float upwards = 1.0f - (static_cast<float>(y) + 0.5f) * perPixel.y;
      span.rayStep = constants.right * perPixel.x;
      span.firstRay = constants.middleRay + across * constants.right + upwards * constants.up;
      foamParts(ShadingSources{constants}, span, white);
      for (int i = 0; i < span.count; ++i) {
        frame.foam[at + i] = static_cast<std::uint8_t>(255.0f * white[i] + 0.5f);
      }
    }
  });
}

}  // namespace

void readContents(const FrameTargets& targets, std::span<const SceneObject> objects,
                  const ShadingConstants& constants, Frame& frame) {
  if (!frame.radiance.empty()) readRadiance(targets, frame);
  if (frame.instances.empty()) return;
  if (objects.size() > ObjectPass::mostTold) {
    throw InputError("labels: this variant tells " + std::to_string(ObjectPass::mostTold) +
                     " objects apart; there are " + std::to_string(objects.size()) +
                     ": draw with variant 'software'");
  }
  const glm::ivec2 size = targets.size;
  const auto albedo = texelsOf<Albedo>(targets.albedo, size, GL_UNSIGNED_BYTE);
  for (std::size_t i = 0; i < frame.instances.size(); ++i) {
    const std::size_t x = i % size.x, y = size.y - 1 - i / size.x;
    const std::uint8_t number = albedo[y * size.x + x].a;
    const bool isObject = frame.classes[i] == PixelClass::object && number > 0;
    frame.instances[i] = isObject ? objects[number - 1u].instance : std::uint16_t{0};
  }
  readFoam(targets, albedo, constants, frame);
}

}  // namespace seaway::render
