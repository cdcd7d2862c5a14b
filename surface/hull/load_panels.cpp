#include <algorithm>
#include <cmath>

#include "surface/hull/load_work.h"

namespace seaway {

/// Drag on the wet part of a panel.
void LoadWork::drag(const HullModel::Panel& panel, double wetPart, bool cut) {
  const HullCoefficients& c = hull.settings().coefficients;
  const glm::dvec3 u =
      slip[static_cast<std::size_t>(panel.probe)] + glm::cross(turning, panel.middle);
  const double normal = glm::dot(u, panel.normal);
  const double along = std::sqrt(std::max(glm::dot(u, u) - normal * normal, 0.0));
  double push = c.formDrag * std::abs(normal) * normal - friction * along * normal;
  if (cut && normal > 0.0) push += c.slamming * normal * normal;
  const glm::dvec3 force = (-0.5 * seaWaterDensity * wetPart * panel.size) *
                           (push * panel.normal + (friction * along) * u);
  sums.drag.force += force;
  sums.drag.moment += glm::cross(panel.middle, force);
}

/// Wind on the dry part of a panel.
void LoadWork::blow(const HullModel::Panel& panel, double dryPart) {
  const glm::dvec3 u = velocity + glm::cross(turning, panel.middle) - wind;
  const double normal = glm::dot(u, panel.normal);
  const glm::dvec3 force = -0.5 * airDensity * hull.settings().coefficients.windDrag *
                           std::abs(normal) * normal * dryPart * panel.size * panel.normal;
  sums.wind.force += force;
  sums.wind.moment += glm::cross(panel.middle, force);
}

/// Pressure on the wet part of a panel that the surface cuts; that part, and the mean depth on it.
LoadWork::WetPart LoadWork::pressCut(const HullModel::Panel& panel, const Wetness& wetness) {
  const auto& vertices = hull.mesh().vertices;
  const std::uint32_t i = panel.corners[wetness.lone], j = panel.corners[(wetness.lone + 1) % 3],
                      k = panel.corners[(wetness.lone + 2) % 3];
  const glm::dvec3 n = vertices[i] + wetness.next * (vertices[j] - vertices[i]);
  const glm::dvec3 m = vertices[i] + wetness.before * (vertices[k] - vertices[i]);
  const auto& pressure = scratch.pressure_;
  const auto& depth = scratch.depth_;
  const double loneShare = wetness.next * wetness.before;
  if (wetness.wet == 1) {
    sums.press(loneShare * panel.area, vertices[i], n, m, pressure[i], 0.0, 0.0);
    return {loneShare, depth[i] / 3.0};
  }
  // Triangles n, j, k and n, k, m: the first has 1 − next of the whole.
  const double whole = 1.0 - loneShare, first = 1.0 - wetness.next, second = whole - first;
  sums.press(first * panel.area, n, vertices[j], vertices[k], 0.0, pressure[j], pressure[k]);
  sums.press(second * panel.area, n, vertices[k], m, 0.0, pressure[k], 0.0);
  return {whole,
          (first * (depth[j] + depth[k]) + second * depth[k]) / (3.0 * std::max(whole, 1e-300))};
}

void LoadWork::pressPanels() {
  const glm::dvec3 up = bodyFromWorld[2];
  const auto& depth = scratch.depth_;
  const auto& pressure = scratch.pressure_;
  for (const HullModel::Panel& panel : hull.panels()) {
    const std::uint32_t i = panel.corners.x, j = panel.corners.y, k = panel.corners.z;
    const Wetness wetness({depth[i], depth[j], depth[k]});
    if (wetness.wet == 0) {
      if (options.wind) blow(panel, 1.0);
      continue;
    }
    WetPart wet{1.0, (depth[i] + depth[j] + depth[k]) * (1.0 / 3.0)};
    if (wetness.wet == 3) {
      sums.press(panel, pressure[i], pressure[j], pressure[k]);
    } else {
      wet = pressCut(panel, wetness);
      if (options.wind) blow(panel, 1.0 - wet.share);
    }
    sums.volume -= wet.share * wet.meanDepth * glm::dot(panel.area, up);
    sums.wetted += wet.share * panel.size;
    if (flows) drag(panel, wet.share, wetness.wet != 3);
  }
}

}  // namespace seaway
