#include "render/gl/stamp_pass.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <optional>
#include <vector>

#include "surface/angles.h"

namespace seaway::render {
namespace {

/// As stamps.vert reads it.
struct Instance {
  glm::vec4 texels;  // first column and row, one past the last of each
  glm::vec4 placed;  // centre from the foot, m; first axis, unit
  glm::vec4 halfAndHeight;
};

/// Texels whose points may lie within `reach` m of `centre`.
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

}  // namespace

StampPass::StampPass(std::string_view shape)
    : program_({"stamps.vert"}, {"field_buffers.glsl", shape, "stamps.frag"}),
      array_(makeVertexArray()) {
  glVertexArrayVertexBuffer(array_, 0, instances_, 0, sizeof(Instance));
  glVertexArrayBindingDivisor(array_, 0, 1);
  for (GLuint i = 0; i < 3; ++i) floatAttribute(array_, i, 4, i * sizeof(glm::vec4));
}

GLuint StampPass::draw(std::span<const Stamp> stamps, glm::dvec2 foot,
                       std::span<const TwinRow> rows, int columns) {
  const glm::ivec2 size(columns, static_cast<int>(rows.size()));
  if (size != size_) {
    texture_ = makeTexture(GL_RGBA32F, size, GL_LINEAR);
    framebuffer_ = makeFramebuffer({texture_});
    size_ = size;
  }
  std::vector<Instance> instances;
  for (const Stamp& stamp : stamps) {
    const glm::vec2 centre(stamp.centre - foot);
    const auto reach = static_cast<float>(glm::length(stamp.halfSize));
    const auto texels = texelsAround(centre, reach, rows, columns);
    if (!texels) continue;
    instances.push_back({*texels, glm::vec4(centre, glm::vec2(unitVector(stamp.toward))),
                         glm::vec4(glm::vec2(stamp.halfSize), stamp.height, 0.0f)});
  }
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  glViewport(0, 0, size.x, size.y);
  const float none[4] = {0.0f, 0.0f, 0.0f, 0.0f};
  glClearBufferfv(GL_COLOR, 0, none);
  if (instances.empty()) return texture_;
  instances_.put(std::span<const Instance>(instances));
  GLint before = 0;
  glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &before);
  program_.set("mapSize", glm::vec2(size));
  glUseProgram(program_);
  glBindVertexArray(array_);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(instances.size()));
  glDisable(GL_BLEND);
  glBindVertexArray(static_cast<GLuint>(before));
  return texture_;
}

std::size_t StampPass::memoryBytes() const {
  return instances_.memoryBytes() + static_cast<std::size_t>(size_.x) * size_.y * 16;
}

}  // namespace seaway::render
