#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace seaway::wake {

/// What a point of the surface is given, in this order: η, ∂η/∂x, ∂η/∂y, ∂η/∂t, and the horizontal
/// orbital velocity; two are spare. SI, in the water's frame.
using PointSums = std::array<float, 8>;
enum PointSum : std::size_t { height, slopeX, slopeY, rate, velocityX, velocityY };

/// Two heights maps of one window at two times, ready to be sampled at a time: cubic Hermite
/// between them, from η and ∂η/∂t, and from φ and ∂φ/∂t = −gη; cubic B-spline in space.
struct SheetSampling {
  const float *surfaceBefore, *surfaceAfter;      ///< WakeGrid::surface
  const float *potentialBefore, *potentialAfter;  ///< WakeGrid::potential; null: no velocity
  std::size_t stride;                             ///< cells from row to row
  std::int64_t mask;                              ///< cells − 1
  double perCell;                                 ///< 1/m
  double centreX, centreY, half;                  ///< the window, m: points outside get nothing
  float heightBefore[2], heightAfter[2];          ///< weights of (η, ∂η/∂t) that make η
  float rateBefore[2], rateAfter[2];              ///< ∂η/∂t
  float potentialFromHeight[2];                   ///< weights of η before and after in φ
  float potentialWeights[2];                      ///< of φ
};

/// Hermite weights for `time` between `before` and `after`, s.
void setTime(SheetSampling& sheet, double before, double after, double time);

/// What is wanted beside the height.
enum class SheetQuantities { height, surface, orbital };

/// Adds a sheet at `count` points to `sums`; `allInside` says that all are known to lie in the
/// window. In vector instructions across a point's 4 × 4 cells: the same bits for any batch.
/// Allocates nothing.
void addSheet(const SheetSampling& sheet, SheetQuantities what, const double* x, const double* y,
              std::size_t count, bool allInside, PointSums* sums);

}  // namespace seaway::wake
