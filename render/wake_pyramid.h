#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "surface/disturbance/disturbance_state.h"

namespace seaway::render {

/// One wake window's surface at one time, and ever coarser copies of it for the parts of a grid
/// whose points lie farther apart than its cells.
///
/// Level 0 holds the window's own B-spline coefficients, Hermite-interpolated in time: what it
/// gives is what DisturbanceState::addTo gives. Each further level has cells twice as large and
/// keeps waves of four cells or more within 4 %, of eight within 0.2 %, half of those of two; what
/// slope it loses is kept as a mean square.
class WakePyramid {
 public:
  /// Takes the surface at time `t` (s). Memory is used again.
  void fill(const WakeSheet& sheet, double t);

  struct Level {
    int cells = 0;
    std::size_t stride = 0;      ///< floats from row to row
    std::vector<float> spline;   ///< coefficients, m: rows and columns −1 … cells + 1, periodic
    std::vector<float> missing;  ///< mean-square slope that is not carried, `blocks`² values
    const float* row(int j) const { return spline.data() + (j + 1) * stride + 1; }
    float* row(int j) { return spline.data() + (j + 1) * stride + 1; }
  };
  static constexpr int blocks = 32;
  std::span<const Level> levels() const { return levels_; }

  /// Level for points `spacing` m apart, broken: 0 where they lie as close as the window's cells.
  /// At levels().size() nothing is left but missing slope.
  float levelFor(double spacing) const;

  /// Heights and slopes are added at points of the water's frame (sea plane less the current's
  /// drift, m); `missing` may be empty.
  struct Arrays {
    std::span<float> height, slopeX, slopeY, missing;
  };
  void addTo(std::span<const double> x, std::span<const double> y, float level,
             const Arrays& out) const;

  double cellSize() const { return cellSize_; }  ///< of level 0, m
  double size() const { return cellSize_ * levels_.front().cells; }
  glm::dvec2 centre() const { return centre_; }  ///< of the window, in the water's frame, m

  /// No slope of level 0 is above this: a spline's slope at its cells, half as much again.
  double steepest() const { return steepest_; }

  std::size_t memoryBytes() const;

 private:
  void takeTime(const WakeSheet& sheet, double t);
  void coarsen(const std::vector<float>& values, int cells);

  double cellSize_ = 0.0, steepest_ = 0.0;
  glm::dvec2 centre_{0.0};
  std::vector<Level> levels_;
  std::vector<float> values_, scratch_;  // of the level at work
};

}  // namespace seaway::render
