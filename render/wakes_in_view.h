#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "render/grid_layout.h"
#include "render/wake_pyramid.h"

namespace seaway::render {

/// The wake windows that a grid meets, ready to be sampled at points as far apart as the grid's.
/// Where there are none nothing is held.
class WakesInView {
 public:
  /// Those of `disturbances` (null: none) at time `t` that some row of `layout` about `foot` (sea
  /// plane, m) meets. Memory is used again.
  void fill(const DisturbanceState* disturbances, double t, glm::dvec2 foot,
            const GridLayout& layout);

  bool empty() const { return count_ == 0; }
  std::span<const WakePyramid> sheets() const { return std::span(pyramids_).first(count_); }

  /// How far the water has drifted since the epoch: the water's frame is the sea plane less this.
  glm::dvec2 drift() const { return drift_; }

  /// Adds heights, slopes and the mean-square slopes that points `spacing` m apart cannot carry, at
  /// points of the sea plane, m.
  void addTo(std::span<const double> x, std::span<const double> y, double spacing,
             const WakePyramid::Arrays& out) const;

  /// No slope of the windows' surfaces is above this.
  double steepest() const;

  std::size_t memoryBytes() const;

 private:
  std::vector<WakePyramid> pyramids_;  // the first `count_` are in use
  std::size_t count_ = 0;
  glm::dvec2 drift_{0.0};
};

}  // namespace seaway::render
