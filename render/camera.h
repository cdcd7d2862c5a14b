#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

namespace seaway::render {

/// Where a pinhole camera's picture lies before it, in pixels, by OpenCV's convention: a place x to
/// the right, y downwards and 1 along the view axis from the camera is seen at (fx x + cx, fy y + cy).
/// Whole numbers are the centres of pixels, (0, 0) that of the top left one.
struct Intrinsics {
  double fx = 0.0, fy = 0.0;  ///< focal lengths, (0, 1e7]; pixels that are not square differ in them
  double cx = 0.0, cy = 0.0;  ///< principal point, anywhere
};

/// Brown and Conrady's lens distortion by OpenCV's convention (Brown 1966, "Decentering distortion of
/// lenses"): with x and y as in Intrinsics and r² = x² + y², what would be seen at (x, y) without it
/// is seen at x (1 + k1 r² + k2 r⁴ + k3 r⁶) + 2 p1 x y + p2 (r² + 2 x²),
/// y (1 + k1 r² + k2 r⁴ + k3 r⁶) + p1 (r² + 2 y²) + 2 p2 x y.
struct Distortion {
  double k1 = 0.0, k2 = 0.0, k3 = 0.0, p1 = 0.0, p2 = 0.0;

  bool isNone() const { return k1 == 0.0 && k2 == 0.0 && k3 == 0.0 && p1 == 0.0 && p2 == 0.0; }
};

/// The same pinhole for a picture of another size: each axis scaled by itself.
Intrinsics scaled(const Intrinsics& intrinsics, glm::ivec2 from, glm::ivec2 to);

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
  std::optional<Intrinsics> intrinsics;  ///< of a picture of `size`, in place of the field of view
  /// Of its lens. Techniques draw pinholes alone: those of makeTechnique() bend their pictures, others
  /// refuse it.
  std::optional<Distortion> distortion;

  double aspectRatio() const { return static_cast<double>(size.x) / size.y; }
  glm::dvec3 forward() const;
  glm::dvec3 left() const;
  glm::dvec3 up() const;

  /// `intrinsics`, or those that the field of view comes to.
  Intrinsics pinhole() const;
  /// Half the picture's width and height, m at 1 m along the view axis.
  glm::dvec2 halfPicture() const;
  /// Middle of the picture, to the right and upwards, m at 1 m along the view axis: 0 but for
  /// intrinsics with another principal point.
  glm::dvec2 pictureMiddle() const;
  /// A pixel's width and height, m at 1 m along the view axis.
  glm::dvec2 pixelExtent() const;
  /// One measure of both: the root of their product.
  double pixelAngle() const;

  /// In world axes: the picture's middle at an axial distance of 1, and from there to its right and
  /// its upper edge. A ray is middle + x·right + y·up with x and y in [-1, 1].
  glm::dvec3 middleRay() const;
  glm::dvec3 rightHalf() const;
  glm::dvec3 upperHalf() const;

  /// OpenGL eye space (x right, y up, z backwards) from camera-relative world.
  glm::dmat4 eyeFromRelativeWorld() const;
  /// Clip space (OpenGL, z in [-1, 1]) from eye space.
  glm::dmat4 clipFromEye() const;
  glm::dmat4 clipFromRelativeWorld() const { return clipFromEye() * eyeFromRelativeWorld(); }

  /// Unit direction, in world axes, of the ray through a pixel's centre; (0, 0) is the top left
  /// pixel, fractions are between centres. Of the pinhole: `distortion` is not looked at.
  glm::dvec3 rayThrough(glm::dvec2 pixel) const;
};

/// Throws InputError, naming the value and what is allowed, unless all of `camera` is in range: of
/// intrinsics, that no corner of the picture lies farther than 89.9° from the view axis. Distortion
/// is left to Lens.
void validate(const Camera& camera);

/// Attitude of a body with x forward, y to port, z up, from yaw, pitch and roll in that order, rad.
/// `headingDirection` is the sea-plane direction of the bow (counter-clockwise from east), `pitch`
/// is positive bow up, `roll` positive starboard down.
glm::dquat attitude(double headingDirection, double pitch, double roll);

}  // namespace seaway::render
