#include "sim_bridge/vessel/mesh_builder.h"

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace seaway::bridge {
namespace {

// Corners of a rectangle from its aft starboard and forward port corners, counter-clockwise seen
// from above: aft starboard, forward starboard, forward port, aft port.
std::array<glm::vec3, 4> corners(glm::vec3 from, glm::vec3 to) {
  return {glm::vec3(from.x, from.y, from.z), glm::vec3(to.x, from.y, to.z),
          glm::vec3(to.x, to.y, to.z), glm::vec3(from.x, to.y, from.z)};
}

void addWalls(MeshPart& part, const Block& block) {
  const auto bottom = corners(block.bottomFrom, block.bottomTo);
  const auto top = corners(block.topFrom, block.topTo);
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t j = (i + 1) % 4;
    addQuad(part, bottom[i], bottom[j], top[j], top[i]);
  }
}

}  // namespace

void addTriangle(MeshPart& part, glm::vec3 a, glm::vec3 b, glm::vec3 c) {
  part.vertices.insert(part.vertices.end(), {a, b, c});
}

void addQuad(MeshPart& part, glm::vec3 a, glm::vec3 b, glm::vec3 c, glm::vec3 d) {
  addTriangle(part, a, b, c);
  addTriangle(part, a, c, d);
}

void addBlock(MeshPart& part, const Block& block) {
  addWalls(part, block);
  const auto top = corners(block.topFrom, block.topTo);
  addQuad(part, top[0], top[1], top[2], top[3]);
}

void addWindowBand(MeshPart& part, const Block& block, float from, float to, float proud) {
  const glm::vec3 outward(proud, proud, 0.0f);
  const Block band{glm::mix(block.bottomFrom, block.topFrom, from) - outward,
                   glm::mix(block.bottomTo, block.topTo, from) + outward,
                   glm::mix(block.bottomFrom, block.topFrom, to) - outward,
                   glm::mix(block.bottomTo, block.topTo, to) + outward};
  addBlock(part, band);
}

void finish(render::Mesh& mesh) {
  double radius = 0.0;
  for (const MeshPart& part : mesh.parts) {
    for (const glm::vec3& vertex : part.vertices) {
      radius = std::max(radius, static_cast<double>(glm::length(vertex)));
    }
  }
  mesh.boundingRadius = radius;
}

}  // namespace seaway::bridge
