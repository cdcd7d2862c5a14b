#include "render/software/object_triangles.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "render/fresnel.h"
#include "render/scene_object.h"

namespace seaway::render {

int cutAtLevel(const glm::vec3 (&corners)[3], float level, float upwards, glm::vec3 (&out)[4]) {
  int count = 0;
  for (int i = 0; i < 3; ++i) {
    const glm::vec3 here = corners[i], next = corners[(i + 1) % 3];
    const float depth = upwards * (here.z - level), nextDepth = upwards * (next.z - level);
    if (depth >= 0.0f) out[count++] = here;
    if ((depth >= 0.0f) != (nextDepth >= 0.0f)) {
      out[count] = here + (next - here) * (depth / (depth - nextDepth));
      out[count++].z = level;
    }
  }
  return count;
}

void ObjectTriangles::clear() {
  isMoved_ = false;
  triangles_.clear();
  faces_.clear();
}

void ObjectTriangles::fill(std::span<const SceneObject> objects, const Camera& camera) {
  clear();
  for (const SceneObject& object : objects) {
    if (inView(object, camera)) add(object, camera, nullptr);
  }
}

void ObjectTriangles::fill(std::span<const SceneObject> objects, const Camera& camera,
                           WaterSide side, std::span<const double> levels) {
  clear();
  isMoved_ = true;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const double level = levels[i];
    SceneObject seen = objects[i];
    if (side != WaterSide::below) seen.position.z = 2.0 * level - seen.position.z;
    if (!std::isfinite(level) || !inView(seen, camera)) continue;
    const double origin = relativePosition(objects[i], camera).z - objects[i].position.z;
    const Half half{side, static_cast<float>(origin + level)};
    add(objects[i], camera, &half);
  }
}

void ObjectTriangles::add(const SceneObject& object, const Camera& camera, const Half* half) {
  const ScreenProjection projection(camera);
  const glm::mat3 rotation(glm::mat3_cast(object.worldFromBody));
  const glm::vec3 position(relativePosition(object, camera));
  for (const Mesh::Part& part : object.mesh->parts) {
    for (std::size_t i = 0; i + 2 < part.vertices.size(); i += 3) {
      glm::vec3 corners[3];
      for (int k = 0; k < 3; ++k) corners[k] = rotation * part.vertices[i + k] + position;
      Face face{faceNormal(corners[0], corners[1], corners[2]), part.colour, object.instance};
      if (!half) {
        add(corners, face, projection, false);
        continue;
      }
      const bool mirrored = half->side != WaterSide::below;
      glm::vec3 kept[4];
      const float upwards = half->side == WaterSide::mirrored ? 1.0f : -1.0f;
      const int count = cutAtLevel(corners, half->level, upwards, kept);
      const float scale = mirrored ? -1.0f : static_cast<float>(1.0 / seaWaterIndex);
      face.level = half->level;
      face.scale = 1.0f / scale;
      for (int k = 0; k < count; ++k) kept[k].z = half->level + scale * (kept[k].z - half->level);
      for (int k = 2; k < count; ++k) {
        add({kept[0], kept[k - 1], kept[k]}, face, projection, mirrored);
      }
    }
  }
}

/// `mirrored` corners turn the other way.
void ObjectTriangles::add(const glm::vec3 (&corners)[3], const Face& face,
                          const ScreenProjection& projection, bool mirrored) {
  ScreenTriangle projected[2];
  const int count = projectTriangle(corners, projection, projected);
  if (count == 0) return;
  const float away = glm::dot(faceNormal(corners[0], corners[1], corners[2]), corners[0]);
  const bool seenFromInside = (mirrored ? -away : away) > 0.0f;
  faces_.push_back(face);
  if (seenFromInside) faces_.back().normal = -face.normal;
  for (int k = 0; k < count; ++k) {
    projected[k].object = static_cast<std::uint32_t>(faces_.size());
    triangles_.push_back(projected[k]);
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
  span.hasPlaces = isMoved_;
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
    span.placeLevel[i] = face.level;
    span.placeScale[i] = face.scale;
  }
}

std::size_t ObjectTriangles::memoryBytes() const {
  return triangles_.capacity() * sizeof(ScreenTriangle) + faces_.capacity() * sizeof(Face);
}

}  // namespace seaway::render
