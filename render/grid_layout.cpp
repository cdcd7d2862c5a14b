#include "render/grid_layout.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>

namespace seaway::render {

double RingLaw::radius(int ring) const {
  const double i = ring - 1.0;
  return ring == 0 ? 0.0 : innermost + growth * i * i * i * i;
}

namespace {

GridLayout emptyLayout(glm::ivec2 size) {
  GridLayout layout;
  layout.size = size;
  layout.rows.resize(size.y);
  return layout;
}

}  // namespace

double GridLayout::rowAt(glm::dvec2 place) const {
  const Projector::GridFromPlane& g = fromPlane;
  const double along = glm::dot(place - g.foot, g.azimuth);
  const double axial = std::max(along * g.cosine + g.heightSine, 1e-6);
  const double v = ((along * g.sine - g.heightCosine) / axial - g.leastY) * g.perY;
  const double even = (std::asinh((along - g.back) * g.perScale) - g.first) * g.perLog;
  return std::clamp(glm::mix(v, even, g.logarithmic), 0.0, 1.0) * (size.y - 1);
}

GridLayout projectedLayout(const Projector& projector, const WaveField& waves, glm::ivec2 size) {
  GridLayout layout = emptyLayout(size);
  layout.fromPlane = projector.gridFromPlane();
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
  GridLayout layout = emptyLayout(size);
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

GridLayout radialLayout(const WaveField& waves, glm::dvec2 centre, double reach,
                        const RingOptions& options) {
  const glm::ivec2 size = options.size;
  GridLayout layout = emptyLayout(size);
  layout.fromPlane.foot = centre;
  layout.displacementTolerance = waves.standardDeviation() * std::sqrt(1.0 - options.displacement);
  const double inner = options.innermost;
  layout.rings = RingLaw{inner, std::max(reach - inner, inner) / std::pow(size.y - 2.0, 4)};
  const double angle = 2.0 * std::numbers::pi / (size.x - 1.0);
  for (int column = 0; column < size.x; ++column) {
    const double turn = angle * (column % (size.x - 1));
    layout.spokes.emplace_back(std::cos(turn), std::sin(turn));
  }
  const BandLimit bandLimit(waves);
  for (int row = 0; row < size.y; ++row) {
    const int other = row + 1 < size.y ? row + 1 : row - 1;
    const double radius = layout.rings->radius(row);
    const double beyond = std::abs(layout.rings->radius(other) - radius);
    layout.rows[row].plan = bandLimit.planFor(std::max(angle * radius, beyond));
  }
  return layout;
}

}  // namespace seaway::render
