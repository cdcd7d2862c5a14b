#include "render/gl/object_pass.h"

#include <algorithm>
#include <cstddef>
#include <glm/gtc/matrix_transform.hpp>
#include <vector>

#include "render/gl/frame_targets.h"
#include "render/scene_object.h"

namespace seaway::render {
namespace {

struct ObjectVertex {
  glm::vec3 position, normal, colour;
};

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

}  // namespace

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
  std::size_t number = 0;
  for (const SceneObject& object : objects) {
    ++number;
    if (!inView(object, camera)) continue;
    const std::vector<ObjectVertex> vertices = flatShaded(*object.mesh);
    if (vertices.empty()) continue;
    vertices_.put(std::span(vertices));
    program_.set("tag", static_cast<float>(std::min(number, mostTold + 1)) / 255.0f);
    program_.set("rotation", glm::mat3(glm::mat3_cast(object.worldFromBody)));
    program_.set("position", glm::vec3(relativePosition(object, camera)));
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(vertices.size()));
  }
}

}  // namespace seaway::render
