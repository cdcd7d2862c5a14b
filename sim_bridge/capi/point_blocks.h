#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <glm/vec2.hpp>
#include <span>

#include "sim_bridge/capi/calls.h"
#include "sim_bridge/capi/prepared_water.h"
#include "surface/surface_sample.h"

namespace seaway::bridge::capi {

/// As many points as the field's kernels take at once: a block's samples stay in the first cache.
inline constexpr std::size_t pointsPerBlock = 256;

/// A part of a caller's points in the sea plane.
struct PointBlock {
  std::size_t count = 0;
  std::size_t first = 0;   ///< the caller's number of the first; without a mask the others follow
  bool everyPoint = true;  ///< no mask: `rows` is not filled
  bool geodetic = false;   ///< `placed` is filled
  std::array<glm::dvec2, pointsPerBlock> points;
  std::array<std::size_t, pointsPerBlock> rows;
  std::array<PlacedPoint, pointsPerBlock> placed;

  std::size_t row(std::size_t i) const { return everyPoint ? first + i : rows[i]; }
  std::span<const glm::dvec2> places() const { return std::span(points).first(count); }

  /// What the caller is told of a point: one too far to be placed is out of range, not NaN.
  std::uint32_t statusOf(std::size_t i, SampleStatus status, const seaway_points& given) const {
    if (geodetic && std::isnan(points[i].x) && std::isfinite(given.first[row(i)]) &&
        std::isfinite(given.second[row(i)])) {
      return static_cast<std::uint32_t>(SampleStatus::outOfRange);
    }
    return static_cast<std::uint32_t>(status);
  }
  /// A vector of the plane along what the caller calls east and north.
  glm::dvec2 along(std::size_t i, glm::dvec2 vector) const {
    return geodetic ? placed[i].trueFromPlane(vector) : vector;
  }
};

/// Throws CallError for points that cannot be read.
void requirePoints(const seaway_points* points);

/// Fills the block with points from number `next` on, up to `end`; returns the number after the
/// last that was looked at. `placer` is for geodetic points.
std::size_t fill(PointBlock& block, const seaway_points& points, std::size_t next, std::size_t end,
                 PlanePlacer* placer);

/// The calling thread's block.
PointBlock& threadsBlock();

}  // namespace seaway::bridge::capi
