#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "render/projector.h"

namespace seaway::render::test {

/// The quadrilaterals between a grid's rows, for asking whether one holds a place.
class Coverage {
 public:
  Coverage(const Projector& projector, int rows)
      : lines_(projector.lines(rows)), azimuth_(projector.gridFromPlane().azimuth) {}

  /// True if `place` (m from the foot point) lies within the grid.
  bool holds(glm::dvec2 place) const {
    const double ahead = along(place);
    if (ahead < along(lines_.front().left) || ahead > along(lines_.back().left)) return false;
    const auto beyond = std::upper_bound(
        lines_.begin() + 1, lines_.end() - 1, ahead,
        [&](double value, const Projector::Line& line) { return value < along(line.left); });
    const Projector::Line &far = *beyond, &near = *(beyond - 1);
    const double share = (ahead - along(near.left)) / (along(far.left) - along(near.left));
    const double least = glm::mix(across(near.left), across(far.left), share);
    const double most = glm::mix(across(near.right), across(far.right), share);
    return across(place) >= least && across(place) <= most;
  }

  /// Finite, rows one behind another, none without width, columns all from left to right.
  bool isInOrder() const {
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      const double ahead = along(lines_[i].left), width = across(lines_[i].right - lines_[i].left);
      if (!(width > 0.0) || !std::isfinite(ahead) || !std::isfinite(width)) return false;
      if (std::abs(along(lines_[i].right) - ahead) > 1e-9 * (1.0 + std::abs(ahead) + width)) {
        return false;
      }
      if (i > 0 && !(ahead > along(lines_[i - 1].left))) return false;
    }
    return true;
  }

 private:
  double along(glm::dvec2 p) const { return glm::dot(p, azimuth_); }
  double across(glm::dvec2 p) const { return glm::dot(p, glm::dvec2(azimuth_.y, -azimuth_.x)); }

  std::vector<Projector::Line> lines_;
  glm::dvec2 azimuth_;
};

}  // namespace seaway::render::test
