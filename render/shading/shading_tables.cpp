#include "render/shading/shading_tables.h"

#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "render/fresnel.h"
#include "render/ripples.h"

namespace seaway::render {
namespace {

std::uint32_t quantised(float value, float least, float most, std::uint32_t steps) {
  const float part = std::clamp((value - least) / (most - least), 0.0f, 1.0f);
  return static_cast<std::uint32_t>(part * static_cast<float>(steps) + 0.5f);
}

void addFresnel(ShadingTables& tables) {
  for (const glm::vec4& entry :
       fresnelTable(ShadingTables::fresnelColumns, ShadingTables::fresnelRows)) {
    tables.mirror.push_back(quantised(entry.x, 0.0f, 1.0f, 65535u) |
                            quantised(entry.y, 0.0f, 1.0f, 65535u) << 16);
    tables.area.push_back(entry.z);
  }
}

void addRipples(ShadingTables& tables) {
  constexpr float span = ShadingTables::rippleSpan;
  std::vector<glm::vec3> image = rippleTexture(ShadingTables::rippleSide);
  int side = ShadingTables::rippleSide;
  for (int level = 0; level < ShadingTables::rippleLevels; ++level, side /= 2) {
    const bool last = level + 1 == ShadingTables::rippleLevels;
    for (const glm::vec3& moments : image) {
      const glm::vec3 kept = last ? glm::vec3(0.0f, 0.0f, 1.0f) : moments;
      tables.ripples.push_back(quantised(kept.x, -span, span, 2046u) |
                               quantised(kept.y, -span, span, 2046u) << 11 |
                               quantised(std::sqrt(kept.z), 0.0f, span, 1023u) << 22);
    }
    std::vector<glm::vec3> half;
    for (int y = 0; y < side; y += 2) {
      for (int x = 0; x < side; x += 2) {
        const glm::vec3* at = &image[static_cast<std::size_t>(y) * side + x];
        half.push_back(0.25f * (at[0] + at[1] + at[side] + at[side + 1]));
      }
    }
    image.swap(half);
  }
}

}  // namespace

const ShadingTables& shadingTables() {
  static const ShadingTables tables = [] {
    ShadingTables made;
    addFresnel(made);
    addRipples(made);
    return made;
  }();
  return tables;
}

std::size_t ShadingTables::memoryBytes() const {
  return (mirror.size() + area.size() + ripples.size()) * sizeof(std::uint32_t);
}

RippleMoments unpackRipple(std::uint32_t texel) {
  constexpr float span = ShadingTables::rippleSpan;
  const auto slope = [](std::uint32_t bits) {
    return static_cast<float>(bits) * (2.0f * span / 2046.0f) - span;
  };
  const float root = static_cast<float>(texel >> 22) * (span / 1023.0f);
  return {slope(texel & 2047u), slope(texel >> 11 & 2047u), root * root};
}

}  // namespace seaway::render
