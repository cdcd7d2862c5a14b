#include "surface/terrain/terrain_map.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "surface/input_error.h"

namespace seaway {
namespace {

void validate(const TerrainMap::Grid& grid) {
  const auto fail = [](const std::string& what) { throw InputError("terrain: " + what); };
  const glm::dvec2 numbers = grid.origin + grid.spacing;
  if (!std::isfinite(numbers.x + numbers.y) || !(grid.spacing.x > 0.0 && grid.spacing.y > 0.0)) {
    fail("origin and spacing must be finite, and the spacing above 0 m");
  }
  if (grid.count.x < 2 || grid.count.y < 2) fail("needs two heights or more each way");
  const std::size_t all = static_cast<std::size_t>(grid.count.x) * grid.count.y;
  if (all > TerrainMap::mostHeights) {
    fail(std::to_string(grid.count.x) + " x " + std::to_string(grid.count.y) +
         " heights are not allowed; " + std::to_string(TerrainMap::mostHeights) + " at the most");
  }
  if (grid.heights.size() != all) fail("has not as many heights as its grid");
  const auto broken = std::find_if(grid.heights.begin(), grid.heights.end(),
                                   [](float height) { return !std::isfinite(height); });
  if (broken == grid.heights.end()) return;
  const auto at = static_cast<std::size_t>(broken - grid.heights.begin());
  fail("the height in column " + std::to_string(at % grid.count.x) + " of row " +
       std::to_string(at / grid.count.x) + " is not finite");
}

/// Of a bilinear piece the slope along an axis is largest at an edge of it.
double steepestSlope(const TerrainMap::Grid& grid) {
  float acrossMost = 0.0f, alongMost = 0.0f;
  const std::size_t columns = grid.count.x;
  for (std::size_t i = 0; i < grid.heights.size(); ++i) {
    const float here = grid.heights[i];
    if (i % columns != 0) acrossMost = std::max(acrossMost, std::abs(here - grid.heights[i - 1]));
    if (i >= columns) alongMost = std::max(alongMost, std::abs(here - grid.heights[i - columns]));
  }
  return std::hypot(acrossMost / grid.spacing.x, alongMost / grid.spacing.y);
}

}  // namespace

TerrainMap::TerrainMap(Grid grid, const TerrainLook& look) : look_(look) {
  validate(grid);
  grid_ = std::move(grid);
  most_ = grid_.origin + glm::dvec2(grid_.count - 1) * grid_.spacing;
  perSpacing_ = 1.0 / grid_.spacing;
  const auto [low, high] = std::minmax_element(grid_.heights.begin(), grid_.heights.end());
  lowest_ = *low;
  highest_ = *high;
  steepest_ = steepestSlope(grid_);
}

void TerrainMap::markDry(std::span<const glm::dvec2> points,
                         std::span<SurfaceSample> out) const noexcept {
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!(heightAt(points[i]) >= out[i].height)) continue;
    out[i].height = out[i].verticalVelocity = std::numeric_limits<double>::quiet_NaN();
    out[i].slope = glm::dvec2(std::numeric_limits<double>::quiet_NaN());
    out[i].orbitalVelocity = glm::dvec3(std::numeric_limits<double>::quiet_NaN());
    out[i].error = out[i].bound = 0.0;
    out[i].status |= SampleStatus::dry;
  }
}

}  // namespace seaway
