#include "render/software/object_triangles.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "render/scene_object.h"

namespace seaway::render {

void ObjectTriangles::fill(std::span<const SceneObject> objects, const Camera& camera) {
  triangles_.clear();
  faces_.clear();
  const ScreenProjection projection(camera);
  for (const SceneObject& object : objects) {
    if (!inView(object, camera)) continue;
    const glm::mat3 rotation(glm::mat3_cast(object.worldFromBody));
    const glm::vec3 position(relativePosition(object, camera));
    for (const Mesh::Part& part : object.mesh->parts) {
      for (std::size_t i = 0; i + 2 < part.vertices.size(); i += 3) {
        glm::vec3 corners[3];
        for (int k = 0; k < 3; ++k) corners[k] = rotation * part.vertices[i + k] + position;
        ScreenTriangle projected[2];
        const int count = projectTriangle(corners, projection, projected);
        if (count == 0) continue;
        glm::vec3 normal = faceNormal(corners[0], corners[1], corners[2]);
        if (glm::dot(normal, corners[0]) > 0.0f) normal = -normal;  // seen from inside
        faces_.push_back({normal, part.colour});
        for (int k = 0; k < count; ++k) {
          projected[k].object = static_cast<std::uint32_t>(faces_.size());
          triangles_.push_back(projected[k]);
        }
      }
    }
  }
}

void ObjectTriangles::raster(Strip& strip) const {
  for (const ScreenTriangle& triangle : triangles_) rasterTriangle(triangle, strip);
}

PixelBox ObjectTriangles::boxIn(const Strip& strip) const {
  // Half a pixel beyond their centres.
  const double top = strip.top - 1.0, bottom = strip.top + strip.rows;
  double left = strip.width, right = -1.0;
  for (const ScreenTriangle& t : triangles_) {
    const auto [high, low] = std::minmax({t.y[0], t.y[1], t.y[2]});
    if (low < top || high > bottom) continue;
    const auto [first, last] = std::minmax({t.x[0], t.x[1], t.x[2]});
    left = std::min(left, first);
    right = std::max(right, last);
  }
  const int from = static_cast<int>(std::clamp(std::floor(left), 0.0, double(strip.width)));
  const int to = static_cast<int>(std::clamp(std::ceil(right) + 1.0, 0.0, double(strip.width)));
  return {{from, strip.top}, {std::max(from, to), strip.top + strip.rows}};
}

void ObjectTriangles::fillSpan(const std::uint32_t* which, const float* inverse,
                               PixelSpan& span) const {
  span.hasObjects = false;
  for (int i = 0; i < span.count; ++i) {
    if (which[i] == 0) continue;
    span.hasObjects = true;
    span.kind[i] = ShadedAs::object;
    span.axial[i] = 1.0f / inverse[i];
    const Face& face = faces_[which[i] - 1];
    for (int c = 0; c < 3; ++c) {
      span.normal[c][i] = face.normal[c];
      span.reflectance[c][i] = face.colour[c];
    }
  }
}

std::size_t ObjectTriangles::memoryBytes() const {
  return triangles_.capacity() * sizeof(ScreenTriangle) + faces_.capacity() * sizeof(Face);
}

}  // namespace seaway::render
