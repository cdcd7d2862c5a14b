#include "sim_bridge/vessel/hull_drawing.h"

#include <glm/geometric.hpp>

#include "sim_bridge/vessel/mesh_builder.h"
#include "surface/hull/hull_rooms.h"

namespace seaway::bridge {
namespace {

/// Faces that lie flatter than this are walked on: 45°.
constexpr double deckSlope = 0.7;

void addParts(render::Mesh& drawn, const TriangleMesh& mesh, const VesselDrawing& drawing) {
  MeshPart bottom{{}, {0.22f, 0.04f, 0.03f}};
  MeshPart topsides{{}, drawing.hullColour};
  MeshPart deck{{}, drawing.deckColour};
  for (const auto& t : mesh.triangles) {
    const glm::dvec3 &a = mesh.vertices[t.x], &b = mesh.vertices[t.y], &c = mesh.vertices[t.z];
    const glm::dvec3 area = areaVector(mesh, t);
    const bool flat = area.z > deckSlope * glm::length(area);
    const bool inner = area.y * (a.y + b.y + c.y) < 0.0;  // faces the centreplane
    const bool low = (a.z + b.z + c.z) / 3.0 < 0.0;
    addTriangle(flat || inner ? deck
                : low         ? bottom
                              : topsides,
                glm::vec3(a), glm::vec3(b), glm::vec3(c));
  }
  drawn.parts = {bottom, topsides, deck};
}

}  // namespace

render::Mesh hullDrawing(const VesselModel& model) {
  const auto hull = hullModelOf(model.mesh, model.hull);
  VesselHullMesh shown = model.mesh;
  if (!model.drawing.source.empty()) shown.source = model.drawing.source;
  const TriangleMesh mesh = model.drawing.source.empty() ? hull->mesh() : hullMeshOf(shown);
  const TriangleMesh afloat = moved(mesh, {0.0, 0.0, hull->restHeight()});
  render::Mesh drawn;
  addParts(drawn, afloat, model.drawing);
  for (const HullRoom& room : roomsOf(afloat)) {
    render::Mesh::Hollow hollow;
    for (const glm::dvec4& plane : room.planes) hollow.planes.emplace_back(plane);
    drawn.hollows.push_back(std::move(hollow));
  }
  finish(drawn);
  return drawn;
}

}  // namespace seaway::bridge
