#include "render/camera.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <sstream>
#include <string>
#include <utility>

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

Intrinsics scaled(const Intrinsics& intrinsics, glm::ivec2 from, glm::ivec2 to) {
  const glm::dvec2 scale = glm::dvec2(to) / glm::dvec2(from);
  // Pixels' edges, not their centres, stay where they are.
  return {intrinsics.fx * scale.x, intrinsics.fy * scale.y,
          (intrinsics.cx + 0.5) * scale.x - 0.5, (intrinsics.cy + 0.5) * scale.y - 0.5};
}

Intrinsics Camera::pinhole() const {
  if (intrinsics) return *intrinsics;
  const double focal = 0.5 * size.y / std::tan(0.5 * verticalFieldOfView);
  return {focal, focal, 0.5 * (size.x - 1), 0.5 * (size.y - 1)};
}

glm::dvec2 Camera::halfPicture() const {
  if (intrinsics) return 0.5 * glm::dvec2(size) / glm::dvec2(intrinsics->fx, intrinsics->fy);
  const double halfHeight = std::tan(0.5 * verticalFieldOfView);
  return {halfHeight * aspectRatio(), halfHeight};
}

glm::dvec2 Camera::pictureMiddle() const {
  if (!intrinsics) return {0.0, 0.0};
  return {(0.5 * (size.x - 1) - intrinsics->cx) / intrinsics->fx,
          (intrinsics->cy - 0.5 * (size.y - 1)) / intrinsics->fy};
}

glm::dvec2 Camera::pixelExtent() const {
  if (intrinsics) return 1.0 / glm::dvec2(intrinsics->fx, intrinsics->fy);
  return glm::dvec2(2.0 * std::tan(0.5 * verticalFieldOfView) / size.y);
}

double Camera::pixelAngle() const {
  const glm::dvec2 extent = pixelExtent();
  return std::sqrt(extent.x * extent.y);
}

glm::dvec3 Camera::middleRay() const {
  const glm::dvec2 middle = pictureMiddle();
  return forward() - middle.x * left() + middle.y * up();
}

glm::dvec3 Camera::rightHalf() const { return -left() * halfPicture().x; }
glm::dvec3 Camera::upperHalf() const { return up() * halfPicture().y; }

glm::dmat4 Camera::clipFromEye() const {
  if (!intrinsics) {
    return glm::perspectiveNO(verticalFieldOfView, aspectRatio(), nearDistance, farDistance);
  }
  const glm::dvec2 half = nearDistance * halfPicture(), middle = nearDistance * pictureMiddle();
  return glm::frustumNO(middle.x - half.x, middle.x + half.x, middle.y - half.y,
                        middle.y + half.y, nearDistance, farDistance);
}

glm::dvec3 Camera::rayThrough(glm::dvec2 pixel) const {
  const glm::dvec2 half = halfPicture(), middle = pictureMiddle();
  const double toRight = middle.x + (2.0 * (pixel.x + 0.5) / size.x - 1.0) * half.x;
  const double upwards = middle.y + (1.0 - 2.0 * (pixel.y + 0.5) / size.y) * half.y;
  return glm::normalize(forward() - toRight * left() + upwards * up());
}

namespace {

[[noreturn]] void reject(const std::string& what) { throw InputError("camera: " + what); }

std::string text(double value) {
  std::ostringstream stream;
  stream << value;
  return stream.str();
}

void validateIntrinsics(const Camera& camera) {
  const Intrinsics& in = *camera.intrinsics;
  for (const auto& [name, value] : {std::pair("fx", in.fx), std::pair("fy", in.fy)}) {
    if (!(value > 0.0 && value <= 1e7)) {
      reject(std::string("intrinsics: ") + name + " = " + text(value) +
             " pixels is not allowed; must be above 0 and at most 1e7");
    }
  }
  if (!std::isfinite(in.cx) || !std::isfinite(in.cy)) {
    reject("intrinsics: the principal point must be finite");
  }
  const glm::dvec2 farthest = glm::abs(camera.pictureMiddle()) + camera.halfPicture();
  const double angle = degreesFromRadians(std::atan(glm::length(farthest)));
  if (!(angle <= 89.9)) {
    reject("intrinsics: fx = " + text(in.fx) + ", fy = " + text(in.fy) + ", cx = " + text(in.cx) +
           ", cy = " + text(in.cy) + " of " + std::to_string(camera.size.x) + "x" +
           std::to_string(camera.size.y) + " pixels put a corner of the picture " + text(angle) +
           " degrees from the view axis; must be at most 89.9");
  }
}

}  // namespace

void validate(const Camera& camera) {
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
  if (camera.intrinsics) {
    validateIntrinsics(camera);
  } else if (!(camera.verticalFieldOfView > 0.0 && camera.verticalFieldOfView < pi)) {
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
