#pragma once

#include <glm/vec3.hpp>

#include "render/render_technique.h"

namespace seaway::bridge {

using MeshPart = render::Mesh::Part;

/// Corners counter-clockwise seen from outside.
void addTriangle(MeshPart& part, glm::vec3 a, glm::vec3 b, glm::vec3 c);
void addQuad(MeshPart& part, glm::vec3 a, glm::vec3 b, glm::vec3 c, glm::vec3 d);

/// A block between two horizontal rectangles, (aft, starboard, z) to (forward, port, z) each: a
/// wheelhouse, a mast. The bottom is left open.
struct Block {
  glm::vec3 bottomFrom, bottomTo;
  glm::vec3 topFrom, topTo;
};
void addBlock(MeshPart& part, const Block& block);

/// A band of window around a block, between two parts of its height in [0, 1], standing proud of
/// its walls by `proud` m.
void addWindowBand(MeshPart& part, const Block& block, float from, float to, float proud);

/// Sets the bounding radius from the parts.
void finish(render::Mesh& mesh);

}  // namespace seaway::bridge
