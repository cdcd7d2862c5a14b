#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace seaway::render {

/// A pinhole camera in the sea plane's frame (x east, y north, z up, m).
///
/// It looks along +x of its own frame; +y is to its left, +z up. Matrices are camera-relative:
/// "world" in their names is the sea plane's axes with the camera's position as origin, so that
/// single precision suffices however far from the anchor the camera is.
struct Camera {
  glm::dvec3 position{0.0, 0.0, 2.0};              ///< m; z above the still-water level
  glm::dquat worldFromCamera{1.0, 0.0, 0.0, 0.0};  ///< attitude
  double verticalFieldOfView = 1.0;                ///< rad, (0, π)
  glm::ivec2 size{1280, 720};                      ///< pixels, ≥ 1 each
  double nearDistance = 0.1;                       ///< m, > 0
  double farDistance = 50e3;  ///< m, > nearDistance; only `clipFromEye` and culling of objects use
                              ///< it: the sea is drawn to its horizon

  double aspectRatio() const { return static_cast<double>(size.x) / size.y; }
  glm::dvec3 forward() const;
  glm::dvec3 left() const;
  glm::dvec3 up() const;

  /// OpenGL eye space (x right, y up, z backwards) from camera-relative world.
  glm::dmat4 eyeFromRelativeWorld() const;
  /// Clip space (OpenGL, z in [-1, 1]) from eye space.
  glm::dmat4 clipFromEye() const;
  glm::dmat4 clipFromRelativeWorld() const { return clipFromEye() * eyeFromRelativeWorld(); }

  /// Unit direction, in world axes, of the ray through a pixel's centre; (0, 0) is the top left
  /// pixel, fractions are between centres.
  glm::dvec3 rayThrough(glm::dvec2 pixel) const;
};

/// Throws InputError, naming the value and what is allowed, unless all of `camera` is in range.
void validate(const Camera& camera);

/// Attitude of a body with x forward, y to port, z up, from yaw, pitch and roll in that order, rad.
/// `headingDirection` is the sea-plane direction of the bow (counter-clockwise from east), `pitch`
/// is positive bow up, `roll` positive starboard down.
glm::dquat attitude(double headingDirection, double pitch, double roll);

}  // namespace seaway::render
