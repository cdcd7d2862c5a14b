#include "sim_bridge/scenery_objects.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "render/camera.h"
#include "sim_bridge/vessel/mesh_builder.h"
#include "surface/angles.h"

namespace seaway::bridge {
namespace {

/// Turns straight up into the normal of water with a slope.
glm::dquat tiltOf(glm::dvec2 slope) {
  const double steepness = glm::length(slope);
  if (!(steepness > 1e-12)) return {1.0, 0.0, 0.0, 0.0};
  return glm::angleAxis(std::atan(steepness), glm::dvec3(slope.y, -slope.x, 0.0) / steepness);
}

void floatOn(const WaterSurface& water, double time, render::SceneObject& object) {
  const SurfaceSample sample = water.sample(
      glm::dvec2(object.position), time, {.shortestWavelength = 2.0 * object.mesh->boundingRadius});
  if (!std::isfinite(sample.height)) return;  // aground
  object.position.z += sample.height;
  object.worldFromBody = tiltOf(sample.slope) * object.worldFromBody;
}

}  // namespace

render::Mesh sceneryMesh(const SceneryObject& object) {
  render::Mesh mesh;
  for (const ColouredMesh::Part& from : object.mesh->parts) {
    MeshPart part{{}, from.colour.value_or(object.colour)};
    const auto at = [&](std::uint32_t i) {
      return glm::vec3(object.scale * from.mesh.vertices[i]);
    };
    for (const auto& t : from.mesh.triangles) addTriangle(part, at(t.x), at(t.y), at(t.z));
    mesh.parts.push_back(std::move(part));
  }
  finish(mesh);
  return mesh;
}

render::SceneObject placedScenery(const SceneryObject& object, const render::Mesh& mesh,
                                  const Geodesy& geodesy, const WaterSurface& water, double time) {
  const SeaPlanePoint point =
      geodesy.seaPlaneFromGeodetic(object.place.latitude_deg, object.place.longitude_deg);
  render::SceneObject placed{
      &mesh,
      {point.position, object.place.height},
      render::attitude(towardFromCompassToward(object.heading_deg) + point.convergence,
                       radiansFromDegrees(object.pitch_deg), radiansFromDegrees(object.roll_deg)),
      0,
      render::ObjectKind::scenery};
  if (object.floats) floatOn(water, time, placed);
  return placed;
}

}  // namespace seaway::bridge
