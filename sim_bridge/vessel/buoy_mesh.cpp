#include <cmath>

#include "sim_bridge/vessel/mesh_builder.h"
#include "sim_bridge/vessel/vessel_mesh.h"
#include "surface/constants.h"

namespace seaway::bridge {
namespace {

constexpr int sides = 20;

glm::vec3 onRing(int i, glm::vec2 radii, float height) {
  const float angle = 2.0f * static_cast<float>(pi) * static_cast<float>(i) / sides;
  return {radii.x * std::cos(angle), radii.y * std::sin(angle), height};
}

void addRing(MeshPart& part, glm::vec2 lowRadii, float low, glm::vec2 highRadii, float high) {
  for (int i = 0; i < sides; ++i) {
    addQuad(part, onRing(i, lowRadii, low), onRing(i + 1, lowRadii, low),
            onRing(i + 1, highRadii, high), onRing(i, highRadii, high));
  }
}

void addDisc(MeshPart& part, glm::vec2 radii, float height) {
  for (int i = 0; i < sides; ++i) {
    addTriangle(part, {0.0f, 0.0f, height}, onRing(i, radii, height), onRing(i + 1, radii, height));
  }
}

}  // namespace

render::Mesh buoyMesh(const BoxHull& hull, const VesselDrawing& drawing) {
  const glm::vec2 radii(0.5f * static_cast<float>(hull.length),
                        0.5f * static_cast<float>(hull.beam));
  const float draft = static_cast<float>(hull.draft());
  const float deckHeight = static_cast<float>(hull.depth) - draft;
  const float tower = 1.2f * static_cast<float>(hull.length);
  MeshPart body{{}, drawing.hullColour};
  MeshPart deck{{}, drawing.deckColour};
  MeshPart mast{{}, drawing.houseColour};
  addRing(body, 0.6f * radii, -draft, radii, -0.3f * draft);
  addRing(body, radii, -0.3f * draft, radii, deckHeight);
  addDisc(deck, radii, deckHeight);
  addRing(mast, 0.22f * radii, deckHeight, 0.07f * radii, deckHeight + tower);
  addRing(mast, 0.16f * radii, deckHeight + tower, 0.16f * radii, deckHeight + 1.15f * tower);
  addDisc(mast, 0.16f * radii, deckHeight + 1.15f * tower);
  render::Mesh mesh;
  mesh.parts = {body, deck, mast};
  finish(mesh);
  return mesh;
}

}  // namespace seaway::bridge
