#include "render/gl/stamp_pass.h"

#include <glm/geometric.hpp>
#include <vector>

#include "render/gl/stamp_map.h"
#include "surface/angles.h"

namespace seaway::render {
namespace {

/// As stamps.vert reads it.
struct Instance {
  glm::vec4 texels;  // first column and row, one past the last of each
  glm::vec4 placed;  // centre from the foot, m; first axis, unit
  glm::vec4 halfAndHeight;
};

}  // namespace

StampPass::StampPass(std::string_view shape)
    : program_({"stamps.vert"}, {"field_buffers.glsl", shape, "stamps.frag"}),
      array_(makeVertexArray()) {
  glVertexArrayVertexBuffer(array_, 0, instances_, 0, sizeof(Instance));
  glVertexArrayBindingDivisor(array_, 0, 1);
  for (GLuint i = 0; i < 3; ++i) floatAttribute(array_, i, 4, i * sizeof(glm::vec4));
}

void StampPass::draw(std::span<const Stamp> stamps, glm::dvec2 foot, std::span<const TwinRow> rows,
                     int columns) {
  std::vector<Instance> instances;
  for (const Stamp& stamp : stamps) {
    const glm::vec2 centre(stamp.centre - foot);
    const auto reach = static_cast<float>(glm::length(stamp.halfSize));
    const auto texels = texelsAround(centre, reach, rows, columns);
    if (!texels) continue;
    instances.push_back({*texels, glm::vec4(centre, glm::vec2(unitVector(stamp.toward))),
                         glm::vec4(glm::vec2(stamp.halfSize), stamp.height, 0.0f)});
  }
  if (instances.empty()) return;
  instances_.put(std::span<const Instance>(instances));
  program_.set("mapSize", glm::vec2(columns, rows.size()));
  glUseProgram(program_);
  glBindVertexArray(array_);
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(instances.size()));
}

}  // namespace seaway::render
