#include "render/shading/shading_tables.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/packing.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "render/fresnel.h"
#include "render/ripples.h"
#include "render/shading/foam_pattern.h"

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

/// Mean square of what bilinear filtering shows between a tile's texels: for each axis a third of
/// both ends' and of their product, halved.
double filteredSquare(const std::vector<glm::vec3>& image, int side) {
  const auto at = [&](int x, int y) {
    return glm::dvec2(image[static_cast<std::size_t>(y % side) * side + x % side]);
  };
  double sum = 0.0;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const glm::dvec2 a = at(x, y), b = at(x + 1, y), c = at(x, y + 1), d = at(x + 1, y + 1);
      // Weights' means: 1/9 of a square, 2 · 1/18 of a side, 2 · 1/36 of a diagonal.
      sum += (glm::dot(a, a) + glm::dot(b, b) + glm::dot(c, c) + glm::dot(d, d)) / 9.0 +
             (glm::dot(a, b) + glm::dot(c, d) + glm::dot(a, c) + glm::dot(b, d)) / 9.0 +
             (glm::dot(a, d) + glm::dot(b, c)) / 18.0;
    }
  }
  return sum / (static_cast<double>(side) * side);
}

void addRipples(ShadingTables& tables) {
  constexpr float span = ShadingTables::rippleSpan;
  std::vector<glm::vec3> image = rippleTexture(ShadingTables::rippleSide);
  int side = ShadingTables::rippleSide;
  for (int level = 0; level < ShadingTables::rippleLevels; ++level, side /= 2) {
    const float kept = level + 1 < ShadingTables::rippleLevels ? 1.0f : 0.0f;
    for (const glm::vec3& moments : image) {
      tables.ripples.push_back(glm::packSnorm2x16(kept * glm::vec2(moments) / span));
    }
    tables.rippleKept[level] = kept * static_cast<float>(filteredSquare(image, side));
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

FoamTable makeFoamTable() {
  FoamTable table;
  std::vector<float> image = foamPattern(FoamTable::side);
  int side = FoamTable::side;
  for (int level = 0; level < FoamTable::levels; ++level, side /= 2) {
    double squares = 0.0;
    for (const float value : image) squares += (value - 0.5) * (value - 0.5);
    table.texels.insert(table.texels.end(), image.begin(), image.end());
    const bool last = level + 1 == FoamTable::levels;
    table.kept[level] =
        last ? 0.0f : static_cast<float>(12.0 * squares / static_cast<double>(image.size()));
    std::vector<float> half;
    for (int y = 0; y < side; y += 2) {
      for (int x = 0; x < side; x += 2) {
        const float* at = &image[static_cast<std::size_t>(y) * side + x];
        half.push_back(0.25f * (at[0] + at[1] + at[side] + at[side + 1]));
      }
    }
    image.swap(half);
  }
  return table;
}

}  // namespace

const FoamTable& foamTable() {
  static const FoamTable table = makeFoamTable();
  return table;
}

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

glm::vec2 unpackRipple(std::uint32_t texel) {
  return glm::unpackSnorm2x16(texel) * ShadingTables::rippleSpan;
}

}  // namespace seaway::render
