#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <span>
#include <vector>

#include "surface/surface_sample.h"

namespace seaway {

/// What the ground of a terrain looks like: linear reflectances, by height and slope.
struct TerrainLook {
  glm::vec3 sand{0.42f, 0.35f, 0.24f};   ///< flat ground near the water and below it
  glm::vec3 grass{0.07f, 0.11f, 0.03f};  ///< flat ground higher up
  glm::vec3 rock{0.17f, 0.15f, 0.13f};   ///< steep ground
  glm::vec3 reef{0.10f, 0.11f, 0.05f};   ///< rough ground under water
  double grassFrom = 2.0;                ///< m above the still water from which grass grows
  double rockSlope = 0.7;                ///< rise over run at which half of the ground is rock
  /// How fast water fades in where it begins, 1/m: at a depth of 1/hardness all of it is there
  /// (Toman's shore hardness).
  double shoreHardness = 6.0;
};

/// Ground and sea bed by heights on an even grid of the sea plane, linear between four of them:
/// continuous all over the map. Immutable and thread-safe; queries allocate nothing.
class TerrainMap {
 public:
  /// Heights in m above the still-water level, row by row from the south, each from the west.
  struct Grid {
    glm::dvec2 origin{0.0};   ///< place of the first height, m
    glm::dvec2 spacing{1.0};  ///< m, eastwards and northwards, > 0
    glm::ivec2 count{0};      ///< of heights, ≥ 2 each way
    std::vector<float> heights;
  };
  /// Most heights of a map. It then holds 72 MiB, a technique that draws it six times as much more.
  static constexpr std::size_t mostHeights = std::size_t{4353} * 4353;

  /// Throws InputError unless the grid is as said above and every height is finite.
  explicit TerrainMap(Grid grid, const TerrainLook& look = {});

  const Grid& grid() const { return grid_; }
  const TerrainLook& look() const { return look_; }
  double lowest() const { return lowest_; }      ///< m
  double highest() const { return highest_; }    ///< m
  double steepest() const { return steepest_; }  ///< slope, rise over run
  glm::dvec2 least() const { return grid_.origin; }
  glm::dvec2 most() const { return most_; }

  /// Height at a point of the sea plane, m; −∞ beyond the map, edges belonging to it, and for a
  /// point that is not finite.
  double heightAt(glm::dvec2 point) const noexcept {
    if (!(point.x >= grid_.origin.x && point.x <= most_.x && point.y >= grid_.origin.y &&
          point.y <= most_.y)) {
      return -std::numeric_limits<double>::infinity();
    }
    const glm::dvec2 at = (point - grid_.origin) * perSpacing_;
    const int column = least(static_cast<int>(at.x), grid_.count.x - 2);
    const int row = least(static_cast<int>(at.y), grid_.count.y - 2);
    const double u = at.x - column, v = at.y - row;
    const float* low = &grid_.heights[static_cast<std::size_t>(row) * grid_.count.x + column];
    const float* high = low + grid_.count.x;
    // Weights add to 1 by construction: between equal heights it is that height, to the bit.
    const double south = low[0] + u * (static_cast<double>(low[1]) - low[0]);
    const double north = high[0] + u * (static_cast<double>(high[1]) - high[0]);
    return south + v * (north - south);
  }

  /// Makes samples NaN where ground stands as high as the water or higher, with SampleStatus::dry
  /// and neither error nor bound.
  void markDry(std::span<const glm::dvec2> points, std::span<SurfaceSample> out) const noexcept;

  std::size_t memoryBytes() const { return grid_.heights.capacity() * sizeof(float); }

 private:
  static int least(int a, int b) { return a < b ? a : b; }

  Grid grid_;
  TerrainLook look_;
  glm::dvec2 most_{0.0}, perSpacing_{1.0};
  double lowest_ = 0.0, highest_ = 0.0, steepest_ = 0.0;
};

}  // namespace seaway
