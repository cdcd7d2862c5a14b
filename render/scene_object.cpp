#include "render/scene_object.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "surface/curvature.h"

namespace seaway::render {

glm::dvec3 relativePosition(const SceneObject& object, const Camera& camera) {
  const glm::dvec3 offset = object.position - camera.position;
  return offset - glm::dvec3(0.0, 0.0, seaDrop(glm::length(glm::dvec2(offset))));
}

bool inView(const SceneObject& object, const Camera& camera) {
  if (!object.mesh) return false;
  const glm::dvec3 centre = relativePosition(object, camera);
  const double radius = object.mesh->boundingRadius;
  const double axial = glm::dot(centre, camera.forward());
  if (axial < camera.nearDistance - radius || axial > camera.farDistance + radius) return false;
  const double tanY = std::tan(0.5 * camera.verticalFieldOfView);
  const double tanX = tanY * camera.aspectRatio();
  const double x = std::abs(glm::dot(centre, camera.left()));
  const double y = std::abs(glm::dot(centre, camera.up()));
  return x - axial * tanX <= radius * std::hypot(1.0, tanX) &&
         y - axial * tanY <= radius * std::hypot(1.0, tanY);
}

glm::vec3 faceNormal(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
  const glm::vec3 normal = glm::cross(b - a, c - a);
  const float length = glm::length(normal);
  return length > 0.0f ? normal / length : glm::vec3(0.0f, 0.0f, 1.0f);
}

}  // namespace seaway::render
