#include "render/hollows.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "render/scene_object.h"

namespace seaway::render {
namespace {

bool isInside(const PlacedHollow& hollow, glm::vec3 place) {
  return std::all_of(hollow.planes.begin(), hollow.planes.end(), [&](const glm::vec4& plane) {
    return glm::dot(glm::vec3(plane), place) < plane.w;
  });
}

PlacedHollow placed(const Mesh::Hollow& hollow, const SceneObject& object, const Camera& camera) {
  const glm::mat3 rotation(glm::mat3_cast(object.worldFromBody));
  PlacedHollow result;
  result.middle = glm::vec3(relativePosition(object, camera));
  result.radius = static_cast<float>(object.mesh->boundingRadius);
  for (const glm::vec4& plane : hollow.planes) {
    const glm::vec3 normal = rotation * glm::vec3(plane);
    result.planes.emplace_back(normal, plane.w + glm::dot(normal, result.middle));
  }
  return result;
}

/// Pixels [first, end) that [low, high] covers, in half image planes from the middle.
void cover(double low, double high, int size, int& first, int& end) {
  const auto pixel = [&](double part) {
    return std::clamp(0.5 * (part + 1.0) * size, 0.0, static_cast<double>(size));
  };
  first = static_cast<int>(std::floor(pixel(low)));
  end = static_cast<int>(std::ceil(pixel(high)));
}

}  // namespace

std::vector<PlacedHollow> decideHollows(const View& view, bool waterIsShown) {
  std::vector<PlacedHollow> hollows;
  const bool isWanted = waterIsShown && !view.effects->isOff(Effect::hullMask);
  for (const SceneObject& object : view.objects) {
    if (!isWanted || !object.mesh || object.mesh->hollows.empty()) continue;
    if (!inView(object, view.camera)) continue;
    for (const Mesh::Hollow& hollow : object.mesh->hollows) {
      hollows.push_back(placed(hollow, object, view.camera));
    }
  }
  const char* reason = hollows.empty() ? "no open hull in view" : "an open hull is in view";
  if (!view.effects->decide(Effect::hullMask, !hollows.empty(), reason)) hollows.clear();
  return hollows;
}

PixelBox pixelsOf(const PlacedHollow& hollow, const Camera& camera) {
  const glm::dvec3 middle(hollow.middle);
  const double radius = hollow.radius, axial = glm::dot(middle, camera.forward());
  if (axial - radius <= camera.nearDistance) return {{0, 0}, camera.size};
  const glm::dvec2 half = camera.halfPicture(), picture = camera.pictureMiddle();
  const auto bounds = [&](double offset, double tangent, double centre, double& low, double& high) {
    const double from = offset - radius, to = offset + radius;
    low = from / ((from > 0.0 ? axial + radius : axial - radius) * tangent) - centre / tangent;
    high = to / ((to > 0.0 ? axial - radius : axial + radius) * tangent) - centre / tangent;
  };
  double left, right, top, bottom;
  bounds(-glm::dot(middle, camera.left()), half.x, picture.x, left, right);
  bounds(-glm::dot(middle, camera.up()), half.y, -picture.y, top, bottom);
  PixelBox box;
  cover(left, right, camera.size.x, box.least.x, box.end.x);
  cover(top, bottom, camera.size.y, box.least.y, box.end.y);
  return box;
}

void cutHollows(std::span<const PlacedHollow> hollows, const Camera& camera, Strip& strip) {
  const glm::vec3 middle(camera.middleRay()), up(camera.upperHalf()), right(camera.rightHalf());
  const glm::vec2 perPixel = 2.0f / glm::vec2(camera.size);
  for (const PlacedHollow& hollow : hollows) {
    const PixelBox box = pixelsOf(hollow, camera);
    const int last = std::min(box.end.y, strip.top + strip.rows);
    for (int row = std::max(box.least.y, strip.top); row < last; ++row) {
      float* inverse =
          strip.inverse.data() + static_cast<std::size_t>(row - strip.top) * strip.stride;
      const glm::vec3 line = middle + (1.0f - (static_cast<float>(row) + 0.5f) * perPixel.y) * up;
      for (int x = box.least.x; x < box.end.x; ++x) {
        if (inverse[x] == 0.0f) continue;
        const glm::vec3 ray = line + ((static_cast<float>(x) + 0.5f) * perPixel.x - 1.0f) * right;
        if (isInside(hollow, ray / inverse[x])) inverse[x] = 0.0f;
      }
    }
  }
}

}  // namespace seaway::render
