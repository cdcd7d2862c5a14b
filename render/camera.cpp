#include "render/camera.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <string>

#include "surface/angles.h"
#include "surface/input_error.h"

namespace seaway::render {

glm::dvec3 Camera::forward() const { return worldFromCamera * glm::dvec3(1.0, 0.0, 0.0); }
glm::dvec3 Camera::left() const { return worldFromCamera * glm::dvec3(0.0, 1.0, 0.0); }
glm::dvec3 Camera::up() const { return worldFromCamera * glm::dvec3(0.0, 0.0, 1.0); }

glm::dmat4 Camera::eyeFromRelativeWorld() const {
  const glm::dmat3 worldFromEye(-left(), up(), -forward());
  return glm::dmat4(glm::transpose(worldFromEye));
}

glm::dmat4 Camera::clipFromEye() const {
  return glm::perspectiveNO(verticalFieldOfView, aspectRatio(), nearDistance, farDistance);
}

glm::dvec3 Camera::rayThrough(glm::dvec2 pixel) const {
  const double halfHeight = std::tan(0.5 * verticalFieldOfView);
  const double toRight = (2.0 * (pixel.x + 0.5) / size.x - 1.0) * halfHeight * aspectRatio();
  const double upwards = (1.0 - 2.0 * (pixel.y + 0.5) / size.y) * halfHeight;
  return glm::normalize(forward() - toRight * left() + upwards * up());
}

void validate(const Camera& camera) {
  const auto reject = [](const std::string& what) { throw InputError("camera: " + what); };
  if (camera.size.x < 1 || camera.size.y < 1) {
    reject("image size " + std::to_string(camera.size.x) + "x" + std::to_string(camera.size.y) +
           " is not allowed; both sides must be at least 1 pixel");
  }
  const glm::dvec3 p = camera.position;
  if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) {
    reject("position must be finite");
  }
  if (!(std::abs(glm::length(camera.worldFromCamera) - 1.0) < 1e-6)) {
    reject("attitude must be a unit quaternion");
  }
  if (!(camera.verticalFieldOfView > 0.0 && camera.verticalFieldOfView < pi)) {
    reject("vertical field of view " +
           std::to_string(degreesFromRadians(camera.verticalFieldOfView)) +
           " degrees is not allowed; must be above 0 and below 180");
  }
  if (!(camera.nearDistance > 0.0 && camera.farDistance > camera.nearDistance &&
        std::isfinite(camera.farDistance))) {
    reject("near distance must be above 0 and below the far distance, which must be finite");
  }
}

glm::dquat attitude(double headingDirection, double pitch, double roll) {
  const glm::dquat yawed = glm::angleAxis(headingDirection, glm::dvec3(0.0, 0.0, 1.0));
  const glm::dquat pitched = glm::angleAxis(-pitch, glm::dvec3(0.0, 1.0, 0.0));
  const glm::dquat rolled = glm::angleAxis(roll, glm::dvec3(1.0, 0.0, 0.0));
  return yawed * pitched * rolled;
}

}  // namespace seaway::render
