#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "surface/surface_sample.h"

namespace seaway {

/// One body of water: closed rings of the sea plane, m, the first around it, the others around
/// islands. The last point of a ring is joined to the first; rings may turn either way.
struct OutlinePolygon {
  std::vector<std::vector<glm::dvec2>> rings;
};

/// Where there is water: inside any of some polygons and outside their holes.
///
/// Edges are binned into an even grid over their bounding box; each cell knows whether its middle
/// is in the water, and a query walks from there to its point across the few edges of that cell
/// alone, by signs of cross products in double. A point on an edge counts as one side or the other.
/// The same index serves shaders (render/shaders/outline.glsl). Immutable and thread-safe; queries
/// allocate nothing.
class WaterOutline {
 public:
  /// Throws InputError ("polygon 0, ring 1: …") where there is no polygon, where a ring has fewer
  /// than 3 different points or no area or a point that is not finite, and where edges of a polygon
  /// cross each other.
  explicit WaterOutline(std::span<const OutlinePolygon> polygons);

  /// Whether there is water at a point of the sea plane; false for one that is not finite.
  bool contains(glm::dvec2 point) const noexcept;

  /// Whether there may be water in a box of the sea plane: false only where there is none. Never
  /// slower than a look at each cell of the index that the box meets.
  bool mayMeet(glm::dvec2 least, glm::dvec2 most) const noexcept;

  /// Makes samples of dry points NaN, with SampleStatus::dry and neither error nor bound.
  void markDry(std::span<const glm::dvec2> points, std::span<SurfaceSample> out) const noexcept;

  double area() const { return area_; }  ///< m²; where polygons overlap, counted twice

  /// The index, for shaders. Edges are relative to `origin`.
  struct Edge {
    glm::dvec2 from{0.0}, to{0.0};  ///< the polygon lies on its left
  };
  struct Cell {
    std::uint32_t firstEdge = 0, edgeCount = 0;
    std::int32_t winding = 0;  ///< at its middle; above 0: water
  };
  glm::dvec2 origin() const { return origin_; }      ///< lower corner of the index, m
  glm::dvec2 cellSize() const { return cellSize_; }  ///< m
  glm::ivec2 cellCount() const { return cellCount_; }
  std::span<const Cell> cells() const { return cells_; }  ///< row by row
  std::span<const Edge> edges() const { return edges_; }  ///< by cell

  std::size_t memoryBytes() const;

 private:
  struct OwnedEdge {
    Edge edge;
    std::size_t polygon;
  };
  std::vector<OwnedEdge> edgesOf(std::span<const OutlinePolygon> polygons);
  void layCells(std::vector<OwnedEdge>& edges);
  void binEdges(std::span<const OwnedEdge> edges);
  void windMiddles(std::span<const OwnedEdge> edges);
  glm::dvec2 middleOf(int column, int row) const {
    return (glm::dvec2(column, row) + 0.5) * cellSize_;
  }

  glm::dvec2 origin_{0.0}, cellSize_{1.0};
  glm::ivec2 cellCount_{1};
  std::vector<Cell> cells_;
  std::vector<Edge> edges_;
  double area_ = 0.0;
};

}  // namespace seaway
