#include "surface/fit/group_start.h"

#include <algorithm>
#include <cmath>

namespace seaway::fit {
namespace {

/// The generator's own bits, not a distribution's: those differ between libraries.
double uniform(std::mt19937_64& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
}

std::size_t nearestPoint(const GroupTarget& target, double f) {
  const auto above = std::lower_bound(target.frequency.begin(), target.frequency.end(), f);
  if (above == target.frequency.end()) return target.points() - 1;
  return static_cast<std::size_t>(above - target.frequency.begin());
}

/// Mean direction and spread (rad) of the target where moments are known nearest to a frequency.
struct Lean {
  double toward = 0.0, spread = 0.0;
};

std::optional<Lean> leanAt(const GroupTarget& target, double f) {
  const std::size_t at = nearestPoint(target, f);
  for (std::size_t off = 0; off < target.points(); ++off) {
    for (const std::size_t p : {at + off, at - off}) {
      if (p >= target.points() || target.east.empty() || !(target.density[p] > 0.0)) continue;
      const double east = target.east[p], north = target.north[p];
      if (!std::isfinite(east + north)) continue;
      const double r1 = std::min(std::hypot(east, north) / target.density[p], 1.0);
      return Lean{std::atan2(north, east), std::sqrt(2.0 * (1.0 - r1))};
    }
  }
  return std::nullopt;
}

/// A direction at quantile `share` of the grid's E^0.7 at the point nearest to a frequency.
double gridDirection(const GroupTarget& target, double f, double share) {
  const std::size_t p = nearestPoint(target, f), count = target.direction.size();
  // Shares count from the emptiest direction, so that no cluster is cut in two.
  const double* row = &target.grid[p * count];
  const auto empty = static_cast<std::size_t>(std::min_element(row, row + count) - row);
  double total = 0.0, sum = 0.0;
  for (std::size_t d = 0; d < count; ++d) total += std::pow(row[d], 0.7);
  for (std::size_t n = 0; n < count; ++n) {
    const std::size_t d = (empty + n) % count;
    sum += std::pow(row[d], 0.7);
    if (sum >= share * total) return target.direction[d];
  }
  return target.direction[empty];
}

void setDirection(const GroupTarget& target, const GroupLayout& layout, std::size_t lane,
                  std::size_t lanes, const GroupLimits& limits, GroupShape<double>& shape) {
  shape.toward = layout.toward;
  shape.directionalWidth = layout.directionalWidth;
  if (!layout.directions) return;
  const auto lean = leanAt(target, shape.frequency);
  if (!target.grid.empty()) {
    const double share = (static_cast<double>(lane) + 0.5) / static_cast<double>(lanes);
    shape.toward = gridDirection(target, shape.frequency, share);
    const double spread = lean ? lean->spread : 0.5;
    shape.directionalWidth =
        std::clamp(2.4 * spread / static_cast<double>(lanes), limits.sharpest, limits.broadest);
    return;
  }
  if (!lean) return;
  // Half of the directions' variance from the lean, half from the octave's own width.
  const double side = lane % 2 == 0 ? 1.0 : -1.0;
  shape.toward = lean->toward + side * lean->spread / std::sqrt(2.0);
  shape.directionalWidth =
      std::clamp(lean->spread / std::sqrt(2.0) / rmsOverWidth, limits.sharpest, limits.broadest);
}

/// How many octaves share a frequency: grids need several.
std::size_t lanesOf(const GroupTarget& target, const GroupLayout& layout) {
  if (!layout.directions || target.grid.empty() || layout.octaves < 8) return 1;
  return layout.octaves < 24 ? 2 : layout.octaves < 48 ? 3 : 4;
}

}  // namespace

GroupState startGroups(const GroupTarget& target, const GroupLayout& layout,
                       const GroupLimits& limits, double depth) {
  const std::size_t lanes = lanesOf(target, layout);
  const std::size_t stations = (layout.octaves + lanes - 1) / lanes;
  std::vector<double> centre;
  for (std::size_t i = 0; i < stations; ++i) {
    const double share = (static_cast<double>(i) + 0.5) / static_cast<double>(stations);
    centre.push_back(target.quantile(share, layout.power));
  }
  GroupState state;
  state.depth = depth;
  for (std::size_t n = 0; n < layout.octaves; ++n) {
    const std::size_t i = n / lanes, lane = lanes > 1 ? n % lanes : i;
    const double left = i > 0 ? centre[i - 1] : limits.lowest;
    const double right = i + 1 < stations ? centre[i + 1] : limits.highest;
    const double room = (right - left) / (i > 0 && i + 1 < stations ? 2.0 : 1.5);
    GroupShape<double> shape;
    shape.frequency = centre[i];
    shape.bandwidth =
        std::clamp(layout.overlap * room, limits.narrowest * centre[i], limits.widest * centre[i]);
    setDirection(target, layout, lane, lanes, limits, shape);
    const double density = target.density[nearestPoint(target, centre[i])];
    const double variance = density * shape.bandwidth / static_cast<double>(lanes);
    state.variance.push_back(std::clamp(variance, 1e-4, 1.0));
    state.shape.push_back(shape);
  }
  return state;
}

void scatterVariances(GroupState& state, double scatter, std::mt19937_64& random) {
  for (double& variance : state.variance) variance *= std::exp(uniform(random, -scatter, scatter));
}

void scatterShapes(GroupState& state, const GroupLimits& limits, std::mt19937_64& random) {
  for (GroupShape<double>& shape : state.shape) {
    shape.frequency = std::clamp(shape.frequency + uniform(random, -1.0, 1.0) * shape.bandwidth,
                                 limits.lowest, limits.highest);
    shape.bandwidth =
        std::clamp(shape.bandwidth * std::exp(uniform(random, -0.5, 0.5)),
                   limits.narrowest * shape.frequency, limits.widest * shape.frequency);
  }
}

}  // namespace seaway::fit
