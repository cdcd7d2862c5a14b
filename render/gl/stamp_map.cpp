#include "render/gl/stamp_map.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace seaway::render {

void StampMap::begin(glm::ivec2 size) {
  if (size != size_) {
    texture_ = makeTexture(GL_RGBA32F, size, GL_LINEAR);
    framebuffer_ = makeFramebuffer({texture_});
    size_ = size;
  }
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  glViewport(0, 0, size.x, size.y);
  const float none[4] = {0.0f, 0.0f, 0.0f, 0.0f};
  glClearBufferfv(GL_COLOR, 0, none);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
}

void StampMap::end() { glDisable(GL_BLEND); }

std::optional<glm::vec4> texelsAround(glm::vec2 centre, float reach, std::span<const TwinRow> rows,
                                      int columns) {
  const glm::vec2 across = glm::normalize(rows.front().step);
  const glm::vec2 away(-across.y, across.x);  // rows follow one another this way or the other
  glm::vec2 least(static_cast<float>(columns), static_cast<float>(rows.size())), most(-1.0f);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const glm::vec2 offset = centre - rows[i].start;
    // A neighbour's reach as well, so that filtering finds what it blends.
    if (std::abs(glm::dot(offset, away)) > reach) continue;
    const float width = glm::length(rows[i].step);
    const float column = glm::dot(offset, across) / width;
    const float half = reach / width;
    if (column + half < 0.0f || column - half > static_cast<float>(columns - 1)) continue;
    const float row = static_cast<float>(i);
    least = glm::min(least, glm::vec2(std::max(std::floor(column - half), 0.0f), row));
    most = glm::max(
        most, glm::vec2(std::min(std::ceil(column + half) + 1.0f, static_cast<float>(columns)),
                        row + 1.0f));
  }
  if (most.y <= least.y) return std::nullopt;
  return glm::vec4(least, most);
}

}  // namespace seaway::render
