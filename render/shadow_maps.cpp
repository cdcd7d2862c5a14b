#include "render/shadow_maps.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "render/fresnel.h"
#include "render/scene_object.h"

namespace seaway::render {
namespace {

constexpr int margin = 3;         // texels about what casts a shadow, in which there is nothing
constexpr double finest = 0.002;  // m
constexpr double lowestSun = 1e-4;
constexpr double farthestShadow = 20e3;  // m
constexpr double deepest = 60.0;         // m below still water that shadows are followed to
constexpr int rowsPerStrip = 64;
/// Who is nearer than this, in m, gets a map of their own for what is as near.
constexpr double reaches[ShadowMaps::most] = {60.0, 600.0, 1e9};

/// From the middle of a thing, `radius` m large, along its shadow.
struct Capsule {
  glm::dvec3 from, to;
  double radius;
};

double distanceOf(const Capsule& c) {
  const glm::dvec3 along = c.to - c.from;
  const double part =
      glm::clamp(-glm::dot(c.from, along) / std::max(glm::dot(along, along), 1e-9), 0.0, 1.0);
  return std::max(glm::length(c.from + part * along) - c.radius, 0.0);
}

bool meetsView(const Capsule& c, const Camera& camera) {
  const glm::dvec2 half = camera.halfPicture(), middle = camera.pictureMiddle();
  const glm::dvec3 forward = camera.forward(), left = camera.left(), up = camera.up();
  const auto outside = [&](const glm::dvec3& inwards) {
    const double room = c.radius * glm::length(inwards);
    return glm::dot(c.from, inwards) < -room && glm::dot(c.to, inwards) < -room;
  };
  return !(outside(forward) || outside((half.x - middle.x) * forward - left) ||
           outside((half.x + middle.x) * forward + left) ||
           outside((half.y + middle.y) * forward - up) ||
           outside((half.y - middle.y) * forward + up));
}

}  // namespace

void ShadowMaps::aim(const View& view, const Lighting& lighting) {
  sun_ = glm::normalize(glm::dvec3(lighting.sunDirection));
  const glm::dvec3 beside = std::abs(sun_.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0);
  right_ = glm::normalize(glm::cross(beside, sun_));
  up_ = glm::cross(sun_, right_);
  stillWater_ = -view.camera.position.z;
  bend_ = glm::dvec3(0.0);
  if (!view.water) return;
  const glm::dvec2 level = glm::dvec2(sun_) / seaWaterIndex;
  const glm::dvec3 refracted(level, std::sqrt(1.0 - glm::dot(level, level)));
  bend_ = (refracted - sun_) / refracted.z;
}

std::vector<ShadowMaps::Caster> ShadowMaps::castersOf(const View& view) const {
  const Camera& camera = view.camera;
  const double pixel = camera.pixelAngle();
  const double bound = view.water ? view.water->heightBound(view.time) : 0.0;
  double lowest = 0.0;  // of all things, above still water
  for (const SceneObject& o : view.objects) {
    if (o.mesh) lowest = std::min(lowest, o.position.z - o.mesh->boundingRadius);
  }
  const double floor = std::max(std::min(-bound, lowest), -deepest);
  std::vector<Caster> casters;
  for (const SceneObject& o : view.objects) {
    if (!o.mesh || !(o.mesh->boundingRadius > 0.0)) continue;
    const glm::dvec3 centre = relativePosition(o, camera);
    const double radius = o.mesh->boundingRadius;
    const double fall = std::max(o.position.z + radius - floor, 0.0);
    const double length = std::min(fall / std::max(sun_.z, lowestSun), farthestShadow);
    const Capsule shadow{centre, centre - sun_ * length, radius};
    const double away = distanceOf(shadow);
    if (radius < 0.5 * pixel * away || !meetsView(shadow, camera)) continue;
    casters.push_back({&o, centre, centre.z - o.position.z, away});
  }
  return casters;
}

/// Leaves of the last map's box what holds anything, by whole texels. What surrounds a map before
/// it would be looked up in a coarser one.
void ShadowMaps::trim(Box& box, double texel) const {
  Box drawn;
  for (const Triangle& t : triangles_) {
    for (const glm::dvec3& p : t.corner) {
      drawn.least = glm::min(drawn.least, glm::dvec2(p));
      drawn.most = glm::max(drawn.most, glm::dvec2(p));
    }
  }
  if (triangles_.empty()) return;
  const glm::dvec2 spare = glm::floor((drawn.least - box.least) / texel);
  box.most = glm::min(box.most, drawn.most);
  box.least = glm::min(box.least + glm::max(spare, glm::dvec2(0.0)) * texel, box.most);
}

void ShadowMaps::place(std::span<const Caster> casters, double pixelAngle, int mostTexels) {
  maps_.clear();
  size_ = {0, 0};
  Box boxes[most];
  double nearest[most];
  for (int i = 0; i < most; ++i) {
    nearest[i] = 1e30;
    for (const Caster& c : casters) {
      if (c.away > reaches[i]) continue;
      const double radius = c.object->mesh->boundingRadius;
      boxes[i].least = glm::min(boxes[i].least, across(c.centre) - radius);
      boxes[i].most = glm::max(boxes[i].most, across(c.centre) + radius);
      nearest[i] = std::min(nearest[i], c.away);
    }
    boxes[i].least = glm::max(boxes[i].least, glm::dvec2(-2.0 * reaches[i]));
    boxes[i].most = glm::min(boxes[i].most, glm::dvec2(2.0 * reaches[i]));
  }
  const auto extentOf = [](const Box& b) {
    return std::max(b.most.x - b.least.x, b.most.y - b.least.y);
  };
  for (int i = 0; i < most; ++i) {
    const double extent = extentOf(boxes[i]);
    if (!(extent > 0.0) || (i + 1 < most && extent > 0.5 * extentOf(boxes[i + 1]))) continue;
    // No finer than half a pixel where the nearest shadow may be.
    const double texel = std::max({extent / mostTexels, 0.5 * pixelAngle * nearest[i], finest});
    if (i + 1 == most) trim(boxes[i], texel);
    const glm::ivec2 size =
        glm::ivec2(glm::ceil((boxes[i].most - boxes[i].least) / texel)) + 1 + 2 * margin;
    maps_.push_back({boxes[i].least / texel - double{margin}, texel, size, size_.y});
    size_ = {std::max(size_.x, size.x), size_.y + size.y};
  }
}

void ShadowMaps::add(const glm::dvec3* corners, int count, double level) {
  const auto seen = [&](const glm::dvec3& p) {
    const glm::dvec3 straight = p + bend_ * std::max(level - p.z, 0.0);
    return glm::dvec3(across(straight), glm::dot(straight, sun_));
  };
  for (int k = 2; k < count; ++k) {
    triangles_.push_back({{seen(corners[0]), seen(corners[k - 1]), seen(corners[k])}});
  }
}

void ShadowMaps::gather(std::span<const Caster> casters) {
  triangles_.clear();
  for (const Caster& c : casters) {
    const glm::dmat3 rotation(glm::mat3_cast(c.object->worldFromBody));
    for (const Mesh::Part& part : c.object->mesh->parts) {
      for (std::size_t i = 0; i + 2 < part.vertices.size(); i += 3) {
        glm::dvec3 p[3], above[4], below[4];
        for (int k = 0; k < 3; ++k) p[k] = rotation * glm::dvec3(part.vertices[i + k]) + c.centre;
        int highs = 0, lows = 0;
        for (int k = 0; k < 3; ++k) {
          const glm::dvec3 &here = p[k], &next = p[(k + 1) % 3];
          const double up = here.z - c.level, nextUp = next.z - c.level;
          (up >= 0.0 ? above[highs++] : below[lows++]) = here;
          if ((up >= 0.0) == (nextUp >= 0.0)) continue;
          above[highs++] = below[lows++] = here + (next - here) * (up / (up - nextUp));
        }
        add(above, highs, c.level);
        add(below, lows, c.level);
      }
    }
  }
  double least = 0.0;
  for (const Triangle& t : triangles_) {
    for (const glm::dvec3& p : t.corner) least = std::min(least, p.z);
  }
  base_ = least - 1.0;  // heights from there are above 0, which stands for nothing
}

void ShadowMaps::draw() {
  texels_.assign(static_cast<std::size_t>(size_.x) * size_.y, 0.0f);
  for (const Map& map : maps_) {
    const int strips = (map.size.y + rowsPerStrip - 1) / rowsPerStrip;
    tbb::parallel_for(0, strips, [&](int i) {
      const int top = i * rowsPerStrip;
      Strip strip;
      strip.clear(top, std::min(rowsPerStrip, map.size.y - top), map.size.x, false);
      for (const Triangle& t : triangles_) {
        ScreenTriangle onMap{};
        onMap.object = 1;
        for (int k = 0; k < 3; ++k) {
          onMap.x[k] = t.corner[k].x / map.texel - map.least.x;
          onMap.y[k] = t.corner[k].y / map.texel - map.least.y;
          onMap.inverse[k] = t.corner[k].z - base_;
        }
        rasterTriangle(onMap, strip);
      }
      for (int row = 0; row < strip.rows; ++row) {
        std::copy_n(strip.inverse.data() + static_cast<std::size_t>(row) * strip.stride, map.size.x,
                    &texels_[static_cast<std::size_t>(map.row + top + row) * size_.x]);
      }
    });
    tiles_[&map - maps_.data()].fill(&texels_[static_cast<std::size_t>(map.row) * size_.x],
                                     map.size, static_cast<std::size_t>(size_.x));
  }
}

void ShadowMaps::fill(const View& view, const Shown& shown, const Lighting& lighting,
                      int mostTexels) {
  const bool isUp = lighting.sunIsOn && lighting.sunDirection.z > lowestSun;
  const bool falls = shown.water || shown.objects;  // on something
  std::vector<Caster> casters;
  if (isUp && falls && !view.objects.empty() && !view.effects->isOff(Effect::shadows)) {
    aim(view, lighting);
    casters = castersOf(view);
  }
  const bool called = !casters.empty();
  const char* reason = called                 ? "a shadow may fall into the view"
                       : !lighting.sunIsOn    ? "no sun lights the view"
                       : !isUp                ? "the sun is not above the horizon"
                       : view.objects.empty() ? "there is nothing that casts one"
                                              : "nothing is near that casts one";
  if (!view.effects->decide(Effect::shadows, called, reason) || !called) {
    *this = {};
    return;
  }
  gather(casters);
  place(casters, view.camera.pixelAngle(), mostTexels);
  draw();
  view.effects->holdMemory(Effect::shadows, texels_.capacity() * sizeof(float) +
                                                triangles_.capacity() * sizeof(Triangle));
}

void ShadowMaps::setConstants(ShadingConstants& c) const {
  c.shadowCount = static_cast<int>(maps_.size());
  c.shadowRight = glm::vec3(right_);
  c.shadowUp = glm::vec3(up_);
  c.shadowBend = glm::vec3(bend_);
  c.shadowBase = static_cast<float>(base_);
  for (std::size_t i = 0; i < maps_.size(); ++i) {
    c.shadowLeast[i] = glm::vec2(maps_[i].least);
    c.shadowSize[i] = glm::vec2(maps_[i].size);
    c.shadowTexel[i] = static_cast<float>(maps_[i].texel);
    c.shadowRow[i] = static_cast<float>(maps_[i].row);
  }
}

}  // namespace seaway::render
