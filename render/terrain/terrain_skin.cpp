#include "render/terrain/terrain_skin.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>

namespace seaway::render {
namespace {

namespace text {
using uint = std::uint32_t;
using glm::clamp;
using glm::floor;
using glm::mix;
using glm::smoothstep;
using glm::vec2;
using glm::vec3;
#define SHADER inline
#include "render/terrain/terrain_detail.glsl.h"
#undef SHADER
}  // namespace text

/// Middle of a cell.
struct Cell {
  glm::vec2 slope{0.0f};
  float height = 0.0f, roughness = 0.0f;
};

Cell cellAt(const TerrainMap::Grid& grid, int column, int row) {
  const auto at = [&](int x, int y) {
    x = std::clamp(x, 0, grid.count.x - 1);
    y = std::clamp(y, 0, grid.count.y - 1);
    return grid.heights[static_cast<std::size_t>(y) * grid.count.x + x];
  };
  const float a = at(column, row), b = at(column + 1, row);
  const float c = at(column, row + 1), d = at(column + 1, row + 1);
  Cell cell;
  cell.slope = 0.5f * glm::vec2(b + d - a - c, c + d - a - b) / glm::vec2(grid.spacing);
  cell.height = 0.25f * (a + b + c + d);
  // The next heights around, against these: what no plane has.
  const float around = at(column - 1, row) + at(column + 2, row) + at(column - 1, row + 1) +
                       at(column + 2, row + 1) + at(column, row - 1) + at(column + 1, row - 1) +
                       at(column, row + 2) + at(column + 1, row + 2);
  cell.roughness = std::abs(0.125f * around - cell.height) /
                   static_cast<float>(std::min(grid.spacing.x, grid.spacing.y));
  return cell;
}

glm::vec3 reflectanceOf(const Cell& cell, const TerrainLook& look, glm::vec2 place) {
  const float steep = glm::length(cell.slope), rock = static_cast<float>(look.rockSlope);
  const float patches = text::groundNoise(place / 47.0f) + 0.5f * text::groundNoise(place / 13.0f);
  const float grassFrom = static_cast<float>(look.grassFrom);
  const float rise = 0.5f * std::abs(grassFrom) + 0.5f;
  const float green = glm::smoothstep(grassFrom - 0.5f * rise, grassFrom + rise,
                                      cell.height + 0.6f * rise * patches);
  glm::vec3 ground = glm::mix(look.sand, look.grass * (1.0f + 0.35f * patches), green);
  const float under = glm::smoothstep(0.2f, 1.0f, -cell.height);
  const float rough = glm::smoothstep(0.02f, 0.09f, cell.roughness + 0.01f * patches);
  ground = glm::mix(ground, look.reef * (1.0f + 0.4f * patches), under * rough);
  const float bare = glm::smoothstep(0.65f * rock, 1.35f * rock, steep + 0.1f * rock * patches);
  return glm::mix(ground, look.rock * (1.0f + 0.2f * patches), bare);
}

TerrainSkin::Colour coded(const glm::vec3& reflectance) {
  const glm::vec3 root = glm::sqrt(glm::clamp(reflectance, 0.0f, 1.0f)) * 255.0f + 0.5f;
  return {static_cast<std::uint8_t>(root.x), static_cast<std::uint8_t>(root.y),
          static_cast<std::uint8_t>(root.z), 255};
}

TerrainSkin::Slope coded(glm::vec2 slope) {
  const glm::vec2 held = glm::clamp(slope / TerrainSkin::mostSlope, -1.0f, 1.0f) * 32767.0f;
  return {static_cast<std::int16_t>(std::lround(held.x)),
          static_cast<std::int16_t>(std::lround(held.y))};
}

}  // namespace

TerrainSkin::TerrainSkin(const TerrainMap& map) {
  const TerrainMap::Grid& grid = map.grid();
  glm::ivec2 size = grid.count - 1;
  extent_ = glm::vec2(map.most() - map.least());
  texelSize_ = static_cast<float>(std::min(grid.spacing.x, grid.spacing.y));
  std::size_t all = 0;
  for (glm::ivec2 side = size;; side /= 2) {
    levels_.push_back({side, all});
    all += static_cast<std::size_t>(side.x) * side.y;
    if ((side.x | side.y) & 1) break;
  }
  colours_.resize(all);
  slopes_.resize(all);
  tbb::parallel_for(0, size.y, [&](int row) {
    for (int column = 0; column < size.x; ++column) {
      const std::size_t i = static_cast<std::size_t>(row) * size.x + column;
      const Cell cell = cellAt(grid, column, row);
      slopes_[i] = coded(cell.slope);
      colours_[i] =
          coded(reflectanceOf(cell, map.look(), glm::vec2(glm::dvec2(column, row) * grid.spacing)));
    }
  });
  for (std::size_t l = 1; l < levels_.size(); ++l) {
    const Level& from = levels_[l - 1];
    const Level& to = levels_[l];
    tbb::parallel_for(0, to.size.y, [&](int row) {
      for (int column = 0; column < to.size.x; ++column) {
        glm::vec3 reflectance(0.0f);
        glm::vec2 slope(0.0f);
        for (int k = 0; k < 4; ++k) {
          const std::size_t i = from.first +
                                static_cast<std::size_t>(2 * row + (k >> 1)) * from.size.x +
                                2 * column + (k & 1);
          const glm::vec3 root =
              glm::vec3(colours_[i].red, colours_[i].green, colours_[i].blue) / 255.0f;
          reflectance += 0.25f * root * root;
          slope += 0.25f * mostSlope / 32767.0f * glm::vec2(slopes_[i].x, slopes_[i].y);
        }
        const std::size_t i = to.first + static_cast<std::size_t>(row) * to.size.x + column;
        colours_[i] = coded(reflectance);
        slopes_[i] = coded(slope);
      }
    });
  }
}

TerrainSkin::Texel TerrainSkin::atLevel(glm::vec2 part, std::size_t level) const {
  const Level& l = levels_[level];
  const glm::vec2 at =
      glm::clamp(part * glm::vec2(l.size) - 0.5f, glm::vec2(0.0f), glm::vec2(l.size - 1));
  const glm::ivec2 from = glm::min(glm::ivec2(at), l.size - 1);
  const glm::ivec2 to = glm::min(from + 1, l.size - 1);
  const glm::vec2 weight = at - glm::vec2(from);
  glm::vec3 root(0.0f);
  glm::vec2 slope(0.0f);
  for (int k = 0; k < 4; ++k) {
    const int x = k & 1 ? to.x : from.x, y = k & 2 ? to.y : from.y;
    const std::size_t i = l.first + static_cast<std::size_t>(y) * l.size.x + x;
    const float w = (k & 1 ? weight.x : 1.0f - weight.x) * (k & 2 ? weight.y : 1.0f - weight.y);
    root += w * glm::vec3(colours_[i].red, colours_[i].green, colours_[i].blue);
    slope += w * glm::vec2(slopes_[i].x, slopes_[i].y);
  }
  return {root / 255.0f, slope * (mostSlope / 32767.0f)};
}

TerrainSkin::Texel TerrainSkin::at(glm::vec2 place, float footprint) const {
  const glm::vec2 part = place / extent_;
  const float last = static_cast<float>(levels_.size() - 1);
  const float level = glm::clamp(std::log2(std::max(footprint / texelSize_, 1.0f)), 0.0f, last);
  const auto finer = static_cast<std::size_t>(level);
  Texel texel = atLevel(part, finer);
  const float beyond = level - static_cast<float>(finer);
  if (beyond > 0.0f) {
    const Texel coarser = atLevel(part, finer + 1);
    texel.reflectance = glm::mix(texel.reflectance, coarser.reflectance, beyond);
    texel.slope = glm::mix(texel.slope, coarser.slope, beyond);
  }
  texel.reflectance *= texel.reflectance;
  return texel;
}

GroundPixel groundPixel(const TerrainSkin& skin, glm::vec2 place, float footprint, float height,
                        float wetHeight) {
  const TerrainSkin::Texel texel = skin.at(place, footprint);
  const float grain = text::groundGrain(place, footprint);
  return {glm::normalize(glm::vec3(-texel.slope, 1.0f)),
          text::groundReflectance(texel.reflectance, height, wetHeight, grain)};
}

}  // namespace seaway::render
