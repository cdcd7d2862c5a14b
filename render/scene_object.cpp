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
  const glm::dvec2 half = camera.halfPicture(), middle = camera.pictureMiddle();
  // Not wholly beyond a side of the frustum, whose tangent from the view axis is given.
  const auto reaches = [&](double outwards, double tangent) {
    return outwards - axial * tangent <= radius * std::hypot(1.0, tangent);
  };
  const double right = -glm::dot(centre, camera.left()), up = glm::dot(centre, camera.up());
  return reaches(right, half.x + middle.x) && reaches(-right, half.x - middle.x) &&
         reaches(up, half.y + middle.y) && reaches(-up, half.y - middle.y);
}

glm::vec3 faceNormal(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
  const glm::vec3 normal = glm::cross(b - a, c - a);
  const float length = glm::length(normal);
  return length > 0.0f ? normal / length : glm::vec3(0.0f, 0.0f, 1.0f);
}

}  // namespace seaway::render
