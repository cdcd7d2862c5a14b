#include "render/compare_frames.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

namespace seaway::render {
namespace {

constexpr int silhouetteWidth = 2;      // pixels
constexpr float silhouetteStep = 1.1f;  // ratio of depths

/// Pixels within `silhouetteWidth` of a silhouette: 1.
std::vector<std::uint8_t> nearSilhouettes(const Frame& frame) {
  const glm::ivec2 size = frame.depth.size;
  std::vector<std::uint8_t> near(frame.classes.size(), 0);
  const auto spread = [&](int x, int y) {
    for (int dy = -silhouetteWidth; dy <= silhouetteWidth; ++dy) {
      for (int dx = -silhouetteWidth; dx <= silhouetteWidth; ++dx) {
        const int toX = x + dx, toY = y + dy;
        if (toX < 0 || toY < 0 || toX >= size.x || toY >= size.y) continue;
        near[static_cast<std::size_t>(toY) * size.x + toX] = 1;
      }
    }
  };
  const auto differ = [&](std::size_t a, std::size_t b) {
    if (frame.classes[a] != frame.classes[b]) return true;
    if (frame.classes[a] == PixelClass::sky) return false;
    const float p = frame.depth.metres[a], q = frame.depth.metres[b];
    return std::max(p, q) > silhouetteStep * std::min(p, q);
  };
  for (int y = 0; y < size.y; ++y) {
    for (int x = 0; x < size.x; ++x) {
      const std::size_t i = static_cast<std::size_t>(y) * size.x + x;
      const bool beside = x + 1 < size.x && differ(i, i + 1);
      const bool below = y + 1 < size.y && differ(i, i + size.x);
      if (beside || below) spread(x, y);
      if (beside) spread(x + 1, y);
      if (below) spread(x, y + 1);
    }
  }
  return near;
}

/// Pixels between the projections of the frame's point and of its foot on the reference's plane.
double displacement(const Camera& camera, glm::dvec2 pixel, double depth, double truth,
                    glm::dvec3 normal) {
  const glm::dvec3 ray = camera.rayThrough(pixel);
  const glm::dvec3 perDepth = ray / glm::dot(ray, camera.forward());
  const glm::dvec3 drawn = perDepth * depth;
  const double off = glm::dot(drawn - perDepth * truth, normal);
  const glm::dvec3 foot = drawn - normal * off;
  const double axial = glm::dot(foot, camera.forward());
  if (axial < camera.nearDistance) return 0.0;
  const glm::dvec2 pixelExtent = camera.pixelExtent();
  const glm::dvec3 apart = foot / axial - perDepth;
  return std::hypot(glm::dot(apart, camera.left()) / pixelExtent.x,
                    glm::dot(apart, camera.up()) / pixelExtent.y);
}

double nthOf(std::vector<double>& values, double share) {
  const auto at =
      values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

}  // namespace

FrameComparison compareFrames(const Camera& camera, const Frame& frame, const Frame& reference) {
  const std::vector<std::uint8_t> near = nearSilhouettes(reference);
  FrameComparison result;
  std::vector<double> depths, places;
  double squares = 0.0;
  for (std::size_t i = 0; i < frame.classes.size(); ++i) {
    if (frame.classes[i] == PixelClass::object || reference.classes[i] == PixelClass::object) {
      continue;
    }
    const bool drawn = frame.classes[i] == PixelClass::water;
    const bool wanted = reference.classes[i] == PixelClass::water;
    if (drawn != wanted) {
      ++(wanted ? result.missing : result.extra);
      result.misplaced += near[i] == 0;
    }
    if (!drawn || !wanted || near[i] != 0) continue;
    const glm::dvec2 pixel(static_cast<int>(i) % camera.size.x,
                           static_cast<int>(i) / camera.size.x);
    const double depth = frame.depth.metres[i], truth = reference.depth.metres[i];
    depths.push_back(std::abs(depth - truth));
    places.push_back(displacement(camera, pixel, depth, truth, glm::dvec3(reference.normals[i])));
    squares += places.back() * places.back();
  }
  result.compared = depths.size();
  if (depths.empty()) return result;
  result.depthMedian = nthOf(depths, 0.5);
  result.positionRms = std::sqrt(squares / static_cast<double>(places.size()));
  result.positionPercentile99 = nthOf(places, 0.99);
  return result;
}

}  // namespace seaway::render
