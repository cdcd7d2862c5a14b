#pragma once

#include <glm/vec3.hpp>

#include "render/render_technique.h"

namespace seaway::render {

/// True if the object's bounding sphere meets the camera's frustum (sides, near and far planes).
bool inView(const SceneObject& object, const Camera& camera);

/// Place of the object's origin relative to the camera, on the curved sea, m.
glm::dvec3 relativePosition(const SceneObject& object, const Camera& camera);

/// Outward unit normal of a triangle; upwards for one without area.
glm::vec3 faceNormal(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c);

}  // namespace seaway::render
