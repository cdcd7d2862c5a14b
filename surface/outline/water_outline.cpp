#include "surface/outline/water_outline.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>
#include <limits>
#include <string>

#include "surface/input_error.h"

namespace seaway {
namespace {

double cross(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }

/// Whether a point lies on the left of an edge, where its polygon is.
bool isInside(const WaterOutline::Edge& edge, glm::dvec2 point) {
  return cross(edge.to - edge.from, point - edge.from) > 0.0;
}

bool straddles(double from, double to, double level) { return (from <= level) != (to <= level); }

double signedArea(std::span<const glm::dvec2> ring) {
  double twice = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    // About the ring's first point: far from the anchor the products would cancel.
    twice += cross(ring[i] - ring[0], ring[(i + 1) % ring.size()] - ring[0]);
  }
  return 0.5 * twice;
}

[[noreturn]] void fail(std::size_t polygon, std::size_t ring, const std::string& what) {
  throw InputError("polygon " + std::to_string(polygon) + ", ring " + std::to_string(ring) + ": " +
                   what);
}

/// A ring without repeated points, an outer one counter-clockwise, a hole clockwise.
std::vector<glm::dvec2> orderedRing(const OutlinePolygon& polygon, std::size_t index,
                                    std::size_t which) {
  std::vector<glm::dvec2> ring;
  for (const glm::dvec2 point : polygon.rings[index]) {
    if (!std::isfinite(point.x) || !std::isfinite(point.y)) {
      fail(which, index, "has a point that is not finite");
    }
    if (ring.empty() || ring.back() != point) ring.push_back(point);
  }
  while (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
  if (ring.size() < 3) {
    fail(which, index, "has " + std::to_string(ring.size()) + " different points; needs 3 or more");
  }
  const double area = signedArea(ring);
  glm::dvec2 least = ring[0], most = ring[0];
  for (const glm::dvec2 point : ring) least = glm::min(least, point), most = glm::max(most, point);
  const glm::dvec2 extent = most - least;
  // What rounding makes of points in a row.
  if (std::abs(area) <= 1e-12 * (extent.x * extent.x + extent.y * extent.y)) {
    fail(which, index, "has no area");
  }
  if ((area > 0.0) != (index == 0)) std::reverse(ring.begin(), ring.end());
  return ring;
}

/// Whether two edges cross at an inner point of both.
bool properlyCross(const WaterOutline::Edge& a, const WaterOutline::Edge& b) {
  const auto side = [](const WaterOutline::Edge& edge, glm::dvec2 point) {
    const double value = cross(edge.to - edge.from, point - edge.from);
    return (value > 0.0) - (value < 0.0);
  };
  return side(a, b.from) * side(a, b.to) < 0 && side(b, a.from) * side(b, a.to) < 0;
}

}  // namespace

std::vector<WaterOutline::OwnedEdge> WaterOutline::edgesOf(
    std::span<const OutlinePolygon> polygons) {
  std::vector<OwnedEdge> edges;
  for (std::size_t p = 0; p < polygons.size(); ++p) {
    if (polygons[p].rings.empty()) fail(p, 0, "is missing");
    for (std::size_t r = 0; r < polygons[p].rings.size(); ++r) {
      const std::vector<glm::dvec2> ring = orderedRing(polygons[p], r, p);
      area_ += signedArea(ring);
      for (std::size_t i = 0; i < ring.size(); ++i) {
        edges.push_back({{ring[i], ring[(i + 1) % ring.size()]}, p});
      }
    }
  }
  if (edges.empty()) throw InputError("has no polygon");
  return edges;
}

WaterOutline::WaterOutline(std::span<const OutlinePolygon> polygons) {
  std::vector<OwnedEdge> edges = edgesOf(polygons);
  layCells(edges);
  binEdges(edges);
  windMiddles(edges);
}

void WaterOutline::layCells(std::vector<OwnedEdge>& edges) {
  glm::dvec2 least(std::numeric_limits<double>::infinity()), most = -least;
  for (const OwnedEdge& owned : edges) {
    least = glm::min(least, owned.edge.from);
    most = glm::max(most, owned.edge.from);
  }
  const glm::dvec2 extent = most - least;
  // About four cells an edge leave one or two edges in the cells on the shore.
  const double wanted = std::clamp(4.0 * static_cast<double>(edges.size()), 256.0, 262144.0);
  const double side = std::sqrt(extent.x * extent.y / wanted);
  cellCount_ = glm::clamp(glm::ivec2(glm::ceil(extent / side)), 1, 4096);
  origin_ = least;
  cellSize_ = extent / glm::dvec2(cellCount_);
  for (OwnedEdge& owned : edges) {
    owned.edge.from -= origin_;
    owned.edge.to -= origin_;
  }
}

void WaterOutline::binEdges(std::span<const OwnedEdge> edges) {
  std::vector<std::vector<std::uint32_t>> inCell(static_cast<std::size_t>(cellCount_.x) *
                                                 cellCount_.y);
  const auto clampTo = [](double cell, int count) {
    return std::clamp(static_cast<int>(std::floor(cell)), 0, count - 1);
  };
  constexpr double margin = 1e-9;  // of a cell, against rounding at its sides
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const glm::dvec2 a = edges[i].edge.from / cellSize_, b = edges[i].edge.to / cellSize_;
    const auto [low, high] = std::minmax(a.y, b.y);
    for (int row = clampTo(low - margin, cellCount_.y); row <= clampTo(high + margin, cellCount_.y);
         ++row) {
      const double bottom = std::clamp<double>(row - margin, low, high);
      const double top = std::clamp<double>(row + 1 + margin, low, high);
      const auto across = [&](double y, double level) {
        return a.y == b.y ? level : a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y);
      };
      const double one = across(bottom, a.x), other = across(top, b.x);
      const double left = std::min(one, other), right = std::max(one, other);
      for (int column = clampTo(left - margin, cellCount_.x);
           column <= clampTo(right + margin, cellCount_.x); ++column) {
        inCell[static_cast<std::size_t>(row) * cellCount_.x + column].push_back(
            static_cast<std::uint32_t>(i));
      }
    }
  }
  for (const std::vector<std::uint32_t>& some : inCell) {
    cells_.push_back(
        {static_cast<std::uint32_t>(edges_.size()), static_cast<std::uint32_t>(some.size()), 0});
    for (std::size_t i = 0; i < some.size(); ++i) {
      edges_.push_back(edges[some[i]].edge);
      for (std::size_t j = 0; j < i; ++j) {
        if (edges[some[i]].polygon == edges[some[j]].polygon &&
            properlyCross(edges[some[i]].edge, edges[some[j]].edge)) {
          throw InputError("polygon " + std::to_string(edges[some[i]].polygon) +
                           ": its edges cross each other");
        }
      }
    }
  }
}

void WaterOutline::windMiddles(std::span<const OwnedEdge> edges) {
  std::vector<std::int32_t> change(cellCount_.x + 1);
  std::vector<std::vector<const Edge*>> inRow(cellCount_.y);
  for (const OwnedEdge& owned : edges) {
    const auto [low, high] = std::minmax(owned.edge.from.y, owned.edge.to.y);
    const int first = std::max(0, static_cast<int>(low / cellSize_.y) - 1);
    const int last = std::min(cellCount_.y - 1, static_cast<int>(high / cellSize_.y) + 1);
    for (int row = first; row <= last; ++row) {
      if (straddles(low, high, middleOf(0, row).y)) inRow[row].push_back(&owned.edge);
    }
  }
  for (int row = 0; row < cellCount_.y; ++row) {
    std::fill(change.begin(), change.end(), 0);
    const double y = middleOf(0, row).y;
    for (const Edge* edge : inRow[row]) {
      const bool rises = edge->to.y > edge->from.y;
      const double at = edge->from.x + (edge->to.x - edge->from.x) * (y - edge->from.y) /
                                           (edge->to.y - edge->from.y);
      int column = std::clamp(static_cast<int>(at / cellSize_.x) - 1, 0, cellCount_.x);
      // The first middle beyond the edge, told by the same sign as queries use.
      while (column < cellCount_.x && isInside(*edge, middleOf(column, row)) == rises) ++column;
      change[column] += rises ? -1 : 1;
    }
    std::int32_t winding = 0;
    for (int column = 0; column < cellCount_.x; ++column) {
      winding += change[column];
      cells_[static_cast<std::size_t>(row) * cellCount_.x + column].winding = winding;
    }
  }
}

bool WaterOutline::contains(glm::dvec2 point) const noexcept {
  const glm::dvec2 p = point - origin_, place = p / cellSize_;
  // Not a number is not within.
  if (!(place.x >= 0.0 && place.y >= 0.0 && place.x <= cellCount_.x && place.y <= cellCount_.y)) {
    return false;
  }
  const glm::ivec2 at = glm::min(glm::ivec2(place), cellCount_ - 1);
  const Cell& cell = cells_[static_cast<std::size_t>(at.y) * cellCount_.x + at.x];
  const glm::dvec2 middle = middleOf(at.x, at.y), corner(middle.x, p.y);
  int winding = cell.winding;
  for (std::uint32_t i = 0; i < cell.edgeCount; ++i) {
    const Edge& edge = edges_[cell.firstEdge + i];
    // From the middle upwards or downwards, then sideways to the point.
    const bool beside = isInside(edge, corner);
    if (straddles(edge.from.x, edge.to.x, middle.x)) {
      winding += static_cast<int>(beside) - static_cast<int>(isInside(edge, middle));
    }
    if (straddles(edge.from.y, edge.to.y, p.y)) {
      winding += static_cast<int>(isInside(edge, p)) - static_cast<int>(beside);
    }
  }
  return winding > 0;
}

bool WaterOutline::mayMeet(glm::dvec2 least, glm::dvec2 most) const noexcept {
  const glm::dvec2 count(cellCount_);
  const glm::dvec2 low = (least - origin_) / cellSize_, high = (most - origin_) / cellSize_;
  if (glm::any(glm::greaterThan(low, count)) || glm::any(glm::lessThan(high, glm::dvec2(0.0)))) {
    return false;
  }
  const glm::ivec2 first(glm::clamp(low, glm::dvec2(0.0), count - 1.0));
  const glm::ivec2 last(glm::clamp(high, glm::dvec2(0.0), count - 1.0));
  for (int row = first.y; row <= last.y; ++row) {
    for (int column = first.x; column <= last.x; ++column) {
      const Cell& cell = cells_[static_cast<std::size_t>(row) * cellCount_.x + column];
      if (cell.edgeCount > 0 || cell.winding > 0) return true;
    }
  }
  return false;
}

void WaterOutline::markDry(std::span<const glm::dvec2> points,
                           std::span<SurfaceSample> out) const noexcept {
  constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (contains(points[i])) continue;
    SurfaceSample& sample = out[i];
    sample.height = sample.verticalVelocity = nothing;
    sample.slope = glm::dvec2(nothing);
    sample.orbitalVelocity = glm::dvec3(nothing);
    sample.error = sample.bound = 0.0;
    sample.status |= SampleStatus::dry;
  }
}

std::size_t WaterOutline::memoryBytes() const {
  return cells_.capacity() * sizeof(Cell) + edges_.capacity() * sizeof(Edge);
}

}  // namespace seaway
