#include "render/fresnel.h"

#include <algorithm>
#include <cmath>

namespace seaway::render {

double fresnelReflectance(double cosine, double index) {
  const double incident = std::clamp(cosine, 0.0, 1.0);
  const double sineSquared = (1.0 - incident * incident) / (index * index);
  if (sineSquared >= 1.0) return 1.0;
  const double refracted = std::sqrt(1.0 - sineSquared);
  const double perpendicular = (incident - index * refracted) / (incident + index * refracted);
  const double parallel = (index * incident - refracted) / (index * incident + refracted);
  return 0.5 * (perpendicular * perpendicular + parallel * parallel);
}

RoughReflection roughReflection(double cosine, double slopeDeviation) {
  const double sine = std::sqrt(std::max(1.0 - cosine * cosine, 0.0));
  // Slopes across the line of sight only lengthen the normal: their mean square stands for them.
  const double across = slopeDeviation * slopeDeviation;
  constexpr int steps = 64;
  double weights = 0.0, areas = 0.0, reflected = 0.0, tilts = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double z = -4.0 + 8.0 * (i + 0.5) / steps;
    const double weight = std::exp(-0.5 * z * z);
    const double slope = z * slopeDeviation;  // towards the viewer
    const double area = std::max(cosine + slope * sine, 0.0);
    const double facetCosine = area / std::sqrt(1.0 + slope * slope + across);
    const double part = weight * area * fresnelReflectance(facetCosine);
    weights += weight;
    areas += weight * area;
    reflected += part;
    tilts += part * slope;
  }
  if (!(reflected > 0.0)) return {1.0, 0.0, 0.0};
  return {reflected / areas, tilts / reflected, areas / weights};
}

std::vector<glm::vec4> fresnelTable(int columns, int rows) {
  std::vector<glm::vec4> table;
  table.reserve(static_cast<std::size_t>(columns) * rows);
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const double root = static_cast<double>(column) / (columns - 1);
      const RoughReflection r =
          roughReflection(root * root, fresnelTableRoughest * row / (rows - 1));
      table.emplace_back(r.reflectance, r.tilt, r.area, 0.0);
    }
  }
  return table;
}

}  // namespace seaway::render
