#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "render/fresnel.h"
#include "render/scene_object.h"
#include "render/software/object_triangles.h"

// Scene objects as an eye under still water sees them through its surface.
namespace seaway::render {
namespace {

constexpr int mostSplits = 14;       // of an edge or a face: halves in turn
constexpr double farthest = 5000.0;  // m: farther things lie within a pixel of the window's rim

/// How far from the eye's foot, in m, the ray to a point leaves the water: the point is `far` m
/// away and `high` m above the surface, the eye `depth` m below it. Newton's method on Snell's law,
/// n sin θ below = sin θ above, kept between bounds; to 1e-9 of `far`, which the last step says:
/// the bounds close in from one side only.
double crossingAt(double depth, double far, double high) {
  double low = 0.0, most = far;
  double x = far * depth / (depth + high);
  for (int i = 0; i < 60 && most - low > 1e-9 * far; ++i) {
    const double below = std::sqrt(x * x + depth * depth);
    const double above = std::sqrt((far - x) * (far - x) + high * high);
    const double off = seaWaterIndex * x / below - (far - x) / above;
    (off > 0.0 ? most : low) = x;
    const double rate = seaWaterIndex * depth * depth / (below * below * below) +
                        high * high / (above * above * above);
    const double step = off / rate;
    x -= step;
    if (!(x > low && x < most)) {
      x = 0.5 * (low + most);
    } else if (std::abs(step) <= 1e-9 * far) {
      break;
    }
  }
  return x;
}

}  // namespace

/// A place and where it is seen, both in m from the eye.
struct ObjectTriangles::Bent {
  glm::vec3 place, seen;
};

struct ObjectTriangles::Window {
  ScreenProjection projection;
  double depth;
  double tolerance;  // of directions, rad

  glm::vec3 seen(const glm::vec3& place) const {
    const glm::dvec2 level(place);
    const double far = glm::length(level), high = std::max(place.z - depth, 1e-6);
    if (far < 1e-9) return place;
    const double x = crossingAt(depth, far, high);
    const double length = std::hypot(x, depth) + std::hypot(far - x, high);
    const glm::dvec3 direction = glm::normalize(glm::dvec3(level * (x / far), depth));
    return glm::vec3(direction * length);
  }
  Bent bent(const glm::vec3& place) const { return {place, seen(place)}; }
  /// By how much an edge bends in its middle, rad.
  static double bend(const glm::vec3& start, const glm::vec3& seenMiddle, const glm::vec3& end) {
    const glm::vec3 middle = glm::normalize(seenMiddle);
    const glm::vec3 along = glm::cross(glm::normalize(start), glm::normalize(end));
    const float width = glm::length(along);
    // Off the plane of the ends' rays, and along it where light is to lie where it belongs.
    const float off = width > 1e-9f ? std::abs(glm::dot(middle, along)) / width : 0.0f;
    const float shift = glm::length(middle - glm::normalize(start + end));
    return std::max(off, 0.1f * shift);
  }
};

/// Splits the edge that bends most until none bends by more than the tolerance: neighbours that
/// share an edge split it alike.
void ObjectTriangles::addBent(const Bent (&corners)[3], const Face& face, const Window& window,
                              int splits) {
  double most = 0.0;
  int which = 0;
  Bent middle{};
  for (int k = 0; k < 3 && splits > 0; ++k) {
    const Bent &from = corners[k], &to = corners[(k + 1) % 3];
    const Bent between = window.bent(0.5f * (from.place + to.place));
    const double bend = Window::bend(from.seen, between.seen, to.seen);
    if (bend > most) most = bend, which = k, middle = between;
  }
  if (most > window.tolerance) {
    const Bent &a = corners[which], &b = corners[(which + 1) % 3], &c = corners[(which + 2) % 3];
    addBent({a, middle, c}, face, window, splits - 1);
    addBent({middle, b, c}, face, window, splits - 1);
    return;
  }
  add({corners[0].seen, corners[1].seen, corners[2].seen}, face, window.projection, false);
}

void ObjectTriangles::fillWindow(std::span<const SceneObject> objects, const Camera& camera,
                                 double depth, std::span<const double> levels) {
  clear();
  const Window window{ScreenProjection(camera), depth, camera.pixelAngle() / 3.0};
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const SceneObject& object = objects[i];
    if (!object.mesh || !std::isfinite(levels[i])) continue;
    const glm::dvec3 centre = relativePosition(object, camera);
    if (glm::length(centre) > farthest) continue;
    const auto level = static_cast<float>(centre.z - object.position.z + levels[i]);
    const glm::mat3 rotation(glm::mat3_cast(object.worldFromBody));
    for (const Mesh::Part& part : object.mesh->parts) {
      for (std::size_t k = 0; k + 2 < part.vertices.size(); k += 3) {
        glm::vec3 corners[3], kept[4];
        for (int c = 0; c < 3; ++c) {
          corners[c] = rotation * part.vertices[k + c] + glm::vec3(centre);
        }
        const int count = cutAtLevel(corners, level, 1.0f, kept);
        const Face face{faceNormal(corners[0], corners[1], corners[2]), part.colour,
                        object.instance};
        for (int c = 2; c < count; ++c) {
          addBent({window.bent(kept[0]), window.bent(kept[c - 1]), window.bent(kept[c])}, face,
                  window, mostSplits);
        }
      }
    }
  }
}

}  // namespace seaway::render
