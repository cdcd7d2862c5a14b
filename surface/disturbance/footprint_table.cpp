#include "surface/disturbance/footprint_table.h"

#include <algorithm>
#include <cmath>

namespace seaway {
namespace {

constexpr double phaseStep = 0.15;     // rad at the hull's farthest point
constexpr double mostIntervals = 720;  // 8 MB

}  // namespace

FootprintTable::FootprintTable(const HullFootprint& hull, double depth, double largest)
    : volume_(hull.volume()), extent_(hull.extent()) {
  const double wanted = std::ceil(largest * extent_ / phaseStep);
  alongX_ = alongY_ = static_cast<std::int32_t>(std::clamp(wanted, 16.0, mostIntervals));
  spacing_ = largest / alongX_;
  values_ = hull.tabulate(spacing_, alongX_, alongY_, depth);
}

}  // namespace seaway
