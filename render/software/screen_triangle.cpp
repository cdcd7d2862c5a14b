#include "render/software/screen_triangle.h"

#include <algorithm>
#include <cmath>

namespace seaway::render {

ScreenProjection::ScreenProjection(const Camera& camera) {
  const glm::dvec2 pixel = camera.pixelExtent();
  forward = glm::vec3(camera.forward());
  right = glm::vec3(-camera.left() / pixel.x);
  down = glm::vec3(-camera.up() / pixel.y);
  const Intrinsics pinhole = camera.pinhole();
  middle = glm::vec2(glm::dvec2(pinhole.cx, pinhole.cy));
  nearest = static_cast<float>(camera.nearDistance);
}

int projectTriangle(const glm::vec3 (&corners)[3], const ScreenProjection& projection,
                    ScreenTriangle (&out)[2]) {
  const glm::dvec3 forward(projection.forward), right(projection.right), down(projection.down);
  struct Place {
    double x, y, axial;
  };
  Place kept[4];
  int count = 0;
  const auto place = [&](int i) {
    const glm::dvec3 p(corners[i]);
    return Place{p.x * right.x + p.y * right.y + p.z * right.z,
                 p.x * down.x + p.y * down.y + p.z * down.z,
                 p.x * forward.x + p.y * forward.y + p.z * forward.z};
  };
  const double nearest = projection.nearest;
  for (int i = 0; i < 3; ++i) {
    const Place here = place(i), next = place((i + 1) % 3);
    if (here.axial >= nearest) kept[count++] = here;
    if ((here.axial >= nearest) != (next.axial >= nearest)) {
      const double part = (nearest - here.axial) / (next.axial - here.axial);
      kept[count++] = {here.x + part * (next.x - here.x), here.y + part * (next.y - here.y),
                       nearest};
    }
  }
  for (int i = 2; i < count; ++i) {
    const int which[3] = {0, i - 1, i};
    for (int k = 0; k < 3; ++k) {
      const Place& p = kept[which[k]];
      out[i - 2].x[k] = p.x / p.axial + projection.middle.x;
      out[i - 2].y[k] = p.y / p.axial + projection.middle.y;
      out[i - 2].inverse[k] = 1.0 / p.axial;
    }
    out[i - 2].object = 0;
  }
  return std::max(count - 2, 0);
}

PixelBox boxOf(std::span<const ScreenTriangle> triangles, glm::ivec2 picture) {
  glm::dvec2 least(picture), most(-1.0);
  for (const ScreenTriangle& t : triangles) {
    for (int k = 0; k < 3; ++k) {
      least = glm::min(least, glm::dvec2(t.x[k], t.y[k]));
      most = glm::max(most, glm::dvec2(t.x[k], t.y[k]));
    }
  }
  const glm::dvec2 size(picture);
  const glm::ivec2 from(glm::clamp(glm::floor(least), glm::dvec2(0.0), size));
  return {from,
          glm::max(from, glm::ivec2(glm::clamp(glm::ceil(most) + 1.0, glm::dvec2(0.0), size)))};
}

std::pair<float, float> axialRangeOf(std::span<const ScreenTriangle> triangles) {
  double least = 1e30, most = 0.0;
  for (const ScreenTriangle& t : triangles) {
    for (const double inverse : t.inverse) {
      least = std::min(least, 1.0 / inverse);
      most = std::max(most, 1.0 / inverse);
    }
  }
  return {static_cast<float>(least), static_cast<float>(most)};
}

}  // namespace seaway::render
