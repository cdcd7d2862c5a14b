#pragma once

#include <cstddef>
#include <span>

namespace seaway::render {

/// A level of a WakePyramid as its kernels read it: a window's surface as a cubic B-spline,
/// periodic, and the slope that it lacks by blocks of the window.
struct WakeLevel {
  const float* spline;      ///< coefficient of column −1 in row −1, m
  std::size_t stride;       ///< floats from row to row
  int cells;                ///< along a side, a power of two; 0: no waves
  const float* missing;     ///< `blocks`² mean-square slopes, or null: none
  int blocks;               ///< a power of two
  double centreX, centreY;  ///< of the window, m
  double size;              ///< of its sides, m
};

/// What is added to, an element a point; `missing` may be null.
struct WakeSums {
  float *height, *slopeX, *slopeY, *missing;
};

/// Adds `part` times a level's heights (m), slopes and missing slopes at those of `x`, `y` (m, in
/// the window's frame) that lie in the window. In floats within a cell, as a wake's own samples.
void addWakeLevel(const WakeLevel& level, float part, std::span<const double> x,
                  std::span<const double> y, const WakeSums& sums);

}  // namespace seaway::render
