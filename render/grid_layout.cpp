#include "render/grid_layout.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace seaway::render {

double GridLayout::rowAt(glm::dvec2 place) const {
  const Projector::GridFromPlane& g = fromPlane;
  const double along = glm::dot(place - g.foot, g.azimuth);
  const double axial = std::max(along * g.cosine + g.heightSine, 1e-6);
  const double v = ((along * g.sine - g.heightCosine) / axial - g.leastY) * g.perY;
  const double even = (std::asinh((along - g.back) * g.perScale) - g.first) * g.perLog;
  return std::clamp(glm::mix(v, even, g.logarithmic), 0.0, 1.0) * (size.y - 1);
}

GridLayout projectedLayout(const Projector& projector, const WaveField& waves, glm::ivec2 size) {
  GridLayout layout{size, std::vector<GridLayout::Row>(size.y), projector.gridFromPlane()};
  const BandLimit bandLimit(waves);
  const std::vector<Projector::Line> lines = projector.lines(size.y);
  for (int row = 0; row < size.y; ++row) {
    // All points of a row have the same homogeneous coordinate: they lie evenly between its ends.
    const auto& [left, right] = lines[row];
    layout.rows[row] = {left, (right - left) / (size.x - 1.0), {}};
  }
  for (int row = 0; row < size.y; ++row) {
    // To the next row, or from the one before the last.
    const glm::dvec2 other = layout.rows[row + 1 < size.y ? row + 1 : row - 1].start;
    const double beyond =
        std::abs(glm::dot(other - layout.rows[row].start, layout.fromPlane.azimuth));
    const double spacing = std::max({glm::length(layout.rows[row].step), beyond, 1e-9});
    layout.rows[row].plan = bandLimit.planFor(spacing);
  }
  return layout;
}

GridLayout naiveLayout(const WaveField& waves, double side, glm::ivec2 size) {
  GridLayout layout{size, std::vector<GridLayout::Row>(size.y), {}};
  const glm::dvec2 step = side / (glm::dvec2(size) - 1.0);
  const BandLimit::Plan plan = BandLimit(waves).planFor(std::max(step.x, step.y));
  for (int row = 0; row < size.y; ++row) {
    layout.rows[row] = {{-0.5 * side, -0.5 * side + row * step.y}, {step.x, 0.0}, plan};
  }
  // Seen straight from above by parallel rays: rows grow northwards, columns eastwards.
  Projector::GridFromPlane& g = layout.fromPlane;
  g.azimuth = {0.0, 1.0};
  g.cosine = 0.0;
  g.sine = 1.0;
  g.heightSine = 1.0;
  g.heightCosine = 0.0;
  g.leastY = -0.5 * side;
  g.perY = 1.0 / side;
  return layout;
}

}  // namespace seaway::render
