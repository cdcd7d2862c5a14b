#include "sim_bridge/service/plane_placer.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "surface/angles.h"

namespace seaway::bridge {
namespace {

constexpr double cellSize_deg = 0.004;
constexpr double steepest_deg = 80.0;
constexpr double mostTurns_deg = 720.0;

// WGS84.
constexpr double semiMajorAxis = 6378137.0;
constexpr double flattening = 1.0 / 298.257223563;
constexpr double squaredEccentricity = flattening * (2.0 - flattening);

PlacedPoint placed(const SeaPlanePoint& point) {
  PlacedPoint made;
  if (!point.inRange) {
    made.position = glm::dvec2(std::numeric_limits<double>::quiet_NaN());
    return made;
  }
  made.position = point.position;
  made.turn = unitVector(point.convergence);
  const double distance = glm::length(point.position);
  if (distance > 0.0) made.outward = point.position / distance;
  made.stretch = point.scaleError;
  return made;
}

}  // namespace

glm::dvec2 PlacedPoint::planeFromTrue(glm::dvec2 v) const {
  const glm::dvec2 turned(turn.x * v.x - turn.y * v.y, turn.y * v.x + turn.x * v.y);
  return turned + stretch * (turned - outward * glm::dot(outward, turned));
}

glm::dvec2 PlacedPoint::trueFromPlane(glm::dvec2 v) const {
  return {turn.x * v.x + turn.y * v.y, turn.x * v.y - turn.y * v.x};
}

const PlanePlacer::Cell& PlanePlacer::cellOf(std::int64_t row, std::int64_t column) {
  // Neighbours in an 8 × 8 block never share a place in the table.
  const auto slot = static_cast<std::size_t>(((row & 7) << 3) | (column & 7));
  Cell& cell = cells_[slot];
  if (cell.known && cell.row == row && cell.column == column) return cell;
  cell.row = row;
  cell.column = column;
  cell.known = true;
  cell.latitude_deg = static_cast<double>(row) * cellSize_deg;
  cell.longitude_deg = static_cast<double>(column) * cellSize_deg;
  const SeaPlanePoint centre =
      geodesy_->seaPlaneFromGeodetic(cell.latitude_deg, cell.longitude_deg);
  cell.inRange = centre.inRange;
  cell.centre = placed(centre);
  cell.convergence = centre.convergence;
  const double latitude = radiansFromDegrees(cell.latitude_deg);
  cell.sine = std::sin(latitude);
  cell.cosine = std::cos(latitude);
  const double w2 = 1.0 - squaredEccentricity * cell.sine * cell.sine;
  cell.alongParallel = semiMajorAxis / std::sqrt(w2);
  cell.alongMeridian = cell.alongParallel * (1.0 - squaredEccentricity) / w2;
  return cell;
}

PlacedPoint PlanePlacer::place(double latitude_deg, double longitude_deg) {
  const bool gentle =
      std::abs(latitude_deg) <= steepest_deg && std::abs(longitude_deg) <= mostTurns_deg;
  if (!gentle) return placed(geodesy_->seaPlaneFromGeodetic(latitude_deg, longitude_deg));
  const Cell& cell =
      cellOf(std::llround(latitude_deg / cellSize_deg), std::llround(longitude_deg / cellSize_deg));
  if (!cell.inRange) return placed(geodesy_->seaPlaneFromGeodetic(latitude_deg, longitude_deg));
  const double a = radiansFromDegrees(latitude_deg - cell.latitude_deg);
  const double b = radiansFromDegrees(longitude_deg - cell.longitude_deg);
  const double m = cell.alongMeridian;
  const double n = cell.alongParallel;
  // Geodesic normal coordinates about the centre to second order; dM/dφ ≈ 3 e² M sin φ cos φ, and
  // d(N cos φ)/dφ = −M sin φ.
  const double north = m * a * (1.0 + 1.5 * squaredEccentricity * cell.sine * cell.cosine * a) +
                       0.5 * n * cell.sine * cell.cosine * b * b;
  const double east = n * cell.cosine * b - m * cell.sine * a * b;
  PlacedPoint point = cell.centre;
  point.position += cell.centre.planeFromTrue({east, north});
  point.turn = unitVector(cell.convergence + cell.sine * b);
  return point;
}

}  // namespace seaway::bridge
