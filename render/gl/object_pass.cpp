#include "render/gl/object_pass.h"

#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <vector>

#include "surface/curvature.h"
#include "render/gl/frame_targets.h"

namespace seaway::render {
namespace {

struct ObjectVertex {
  glm::vec3 position, normal, colour;
};

glm::vec3 faceNormal(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
  const glm::vec3 normal = glm::cross(b - a, c - a);
  const float length = glm::length(normal);
  return length > 0.0f ? normal / length : glm::vec3(0.0f, 0.0f, 1.0f);
}

std::vector<ObjectVertex> flatShaded(const Mesh& mesh) {
  std::vector<ObjectVertex> result;
  for (const Mesh::Part& part : mesh.parts) {
    for (std::size_t i = 0; i + 2 < part.vertices.size(); i += 3) {
      const glm::vec3* corner = &part.vertices[i];
      const glm::vec3 normal = faceNormal(corner[0], corner[1], corner[2]);
      for (int k = 0; k < 3; ++k) result.push_back({corner[k], normal, part.colour});
    }
  }
  return result;
}

/// Relative to the camera, on the curved sea.
glm::dvec3 relativePosition(const SceneObject& object, const Camera& camera) {
  const glm::dvec3 offset = object.position - camera.position;
  return offset - glm::dvec3(0.0, 0.0, seaDrop(glm::length(glm::dvec2(offset))));
}

}  // namespace

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

ObjectPass::ObjectPass() : program_({"object.vert"}, {"object.frag"}), array_(makeVertexArray()) {
  glVertexArrayVertexBuffer(array_, 0, vertices_, 0, sizeof(ObjectVertex));
  floatAttribute(array_, 0, 3, offsetof(ObjectVertex, position));
  floatAttribute(array_, 1, 3, offsetof(ObjectVertex, normal));
  floatAttribute(array_, 2, 3, offsetof(ObjectVertex, colour));
}

void ObjectPass::draw(std::span<const SceneObject> objects, const Camera& camera,
                      const glm::mat4& clipFromRelativeWorld) {
  glStencilFunc(GL_ALWAYS, stencilObject, 0xFF);
  glUseProgram(program_);
  glBindVertexArray(array_);
  program_.set("clipFromRelativeWorld", clipFromRelativeWorld);
  for (const SceneObject& object : objects) {
    if (!inView(object, camera)) continue;
    const std::vector<ObjectVertex> vertices = flatShaded(*object.mesh);
    if (vertices.empty()) continue;
    vertices_.put(std::span(vertices));
    program_.set("rotation", glm::mat3(glm::mat3_cast(object.worldFromBody)));
    program_.set("position", glm::vec3(relativePosition(object, camera)));
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(vertices.size()));
  }
}

}  // namespace seaway::render
