#include "render/visible_volume.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "surface/curvature.h"

namespace seaway::render {
namespace {

using FrustumCorners = std::array<glm::dvec3, 8>;  // bit 0: right, bit 1: top, bit 2: far

FrustumCorners frustumCorners(const Camera& camera, double farDistance) {
  const glm::dvec3 eye(0.0, 0.0, camera.position.z);
  const glm::dvec3 middle = camera.middleRay();
  const glm::dvec3 toRight = camera.rightHalf(), upwards = camera.upperHalf();
  FrustumCorners corners;
  for (int i = 0; i < 8; ++i) {
    const glm::dvec3 ray = middle + (i & 1 ? 1.0 : -1.0) * toRight + (i & 2 ? 1.0 : -1.0) * upwards;
    corners[i] = eye + ray * (i & 4 ? farDistance : camera.nearDistance);
  }
  return corners;
}

void addPlaneCrossings(const FrustumCorners& corners, double plane,
                       std::vector<glm::dvec3>& found) {
  for (int from = 0; from < 8; ++from) {
    for (int bit = 1; bit < 8; bit <<= 1) {
      if (from & bit) continue;
      const glm::dvec3 a = corners[from], b = corners[from | bit];
      if ((a.z < plane) == (b.z < plane)) continue;
      found.push_back(a + (b - a) * ((plane - a.z) / (b.z - a.z)));
    }
  }
}

VisibleVolume volumeWithin(const Camera& camera, double heightBound, double reach) {
  const double upper = heightBound;
  const double lower = -heightBound - seaDrop(reach);
  // The point farthest along the view axis is no farther than the farthest point in space.
  const double farDistance =
      std::max(std::hypot(reach, std::abs(camera.position.z) - lower), 2.0 * camera.nearDistance);
  const FrustumCorners frustum = frustumCorners(camera, farDistance);
  VisibleVolume volume;
  addPlaneCrossings(frustum, upper, volume.corners);
  addPlaneCrossings(frustum, lower, volume.corners);
  for (const glm::dvec3& corner : frustum) {
    if (corner.z >= lower && corner.z <= upper) volume.corners.push_back(corner);
  }
  for (const glm::dvec3& corner : volume.corners) {
    volume.reach = std::max(volume.reach, std::hypot(corner.x, corner.y));
  }
  return volume;
}

}  // namespace

std::optional<VisibleVolume> visibleVolume(const Camera& camera, double heightBound) {
  // Still water would make the volume a plane, which rounding could miss.
  const double bound = heightBound + 1e-6 * (1.0 + std::abs(camera.position.z));
  const double horizon = 1.02 * crestReach(std::abs(camera.position.z), bound) + 100.0;
  double reach = horizon;
  VisibleVolume volume;
  // Each volume contains all that is visible, so its reach is a valid and smaller start for the
  // next: looking down, the drop at the horizon does not matter.
  for (int i = 0; i < 4; ++i) {
    volume = volumeWithin(camera, bound, reach);
    if (volume.corners.empty()) return std::nullopt;
    if (volume.reach > 0.95 * reach) break;
    reach = volume.reach;
  }
  volume.reach = std::min(volume.reach, horizon);
  volume.bound = bound;
  return volume;
}

}  // namespace seaway::render
