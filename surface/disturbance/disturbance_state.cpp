#include "surface/disturbance/disturbance_state.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "surface/disturbance/wake_sampling.h"
#include "surface/field/kernels/field_blocks.h"

namespace seaway {
namespace {

using wake::PointSums;
using wake::SheetQuantities;
using wake::SheetSampling;

/// Times this close to a snapshot's ends count as inside: rounding of sums of steps, s.
constexpr double timeRounding = 1e-6;

/// Part of a wake's height that its splines may miss (wake_window_test.cpp measures 0.0012).
constexpr double splineError = 0.005;

SheetSampling samplingOf(const WakeSheet& sheet, double t) {
  SheetSampling sampling{};
  sampling.surfaceBefore = sheet.before->surface.data();
  sampling.surfaceAfter = sheet.after->surface.data();
  const bool moves = !sheet.before->potential.empty() && !sheet.after->potential.empty();
  sampling.potentialBefore = moves ? sheet.before->potential.data() : nullptr;
  sampling.potentialAfter = moves ? sheet.after->potential.data() : nullptr;
  sampling.stride = sheet.before->stride;
  sampling.mask = sheet.before->cells - 1;
  sampling.perCell = 1.0 / sheet.cellSize;
  sampling.centreX = sheet.centre.x;
  sampling.centreY = sheet.centre.y;
  sampling.half = 0.5 * sheet.size();
  wake::setTime(sampling, sheet.start, sheet.end, std::clamp(t, sheet.start, sheet.end));
  return sampling;
}

SheetQuantities quantitiesOf(const SampleOptions& options) {
  return options.orbitalVelocity ? SheetQuantities::orbital
         : options.derivatives   ? SheetQuantities::surface
                                 : SheetQuantities::height;
}

/// Points of a tile in the water's frame, and what they are given.
struct WakeTile {
  alignas(64) double x[pointsPerTile];
  alignas(64) double y[pointsPerTile];
  alignas(64) PointSums sums[pointsPerTile];
  SampleStatus status[pointsPerTile];
  double bound[pointsPerTile];
  std::size_t count = 0;
  glm::dvec2 lower{0.0}, upper{0.0};  // of the points that are not NaN
  bool anyNan = false;

  void begin(std::size_t points) {
    count = points;
    lower = glm::dvec2(std::numeric_limits<double>::infinity());
    upper = -lower;
    anyNan = false;
    std::fill(sums, sums + count, PointSums{});
    std::fill(status, status + count, SampleStatus::ok);
    std::fill(bound, bound + count, 0.0);
  }
  void put(std::size_t i, double px, double py) {
    x[i] = px, y[i] = py;
    anyNan |= std::isnan(px) | std::isnan(py);
    lower = {px < lower.x ? px : lower.x, py < lower.y ? py : lower.y};
    upper = {px > upper.x ? px : upper.x, py > upper.y ? py : upper.y};
  }
  bool meets(glm::dvec2 centre, double half) const {
    return lower.x < centre.x + half && upper.x > centre.x - half && lower.y < centre.y + half &&
           upper.y > centre.y - half;
  }
  bool liesWithin(glm::dvec2 centre, double half) const {
    return lower.x > centre.x - half && upper.x < centre.x + half && lower.y > centre.y - half &&
           upper.y < centre.y + half;
  }
  bool within(std::size_t i, glm::dvec2 centre, double half) const {
    return std::abs(x[i] - centre.x) < half && std::abs(y[i] - centre.y) < half;
  }
  void addBound(double more, glm::dvec2 centre, double half) {
    if (!meets(centre, half)) return;
    for (std::size_t i = 0; i < count; ++i) bound[i] += within(i, centre, half) ? more : 0.0;
  }
  void mark(SampleStatus bits, glm::dvec2 centre, double half) {
    for (std::size_t i = 0; i < count; ++i) {
      if (within(i, centre, half)) status[i] |= bits;
    }
  }
};

/// No |η| of one vessel's waves is above, m.
double heightBoundOf(const VesselWaves& waves) {
  double bound = 0.0;
  for (const WakeSheet& sheet : waves.sheets) {
    // Splines stay within their coefficients; Hermite adds at most 4/27 of step and rates.
    bound += std::max(sheet.before->largestHeight, sheet.after->largestHeight) +
             4.0 / 27.0 * (sheet.end - sheet.start) *
                 (sheet.before->largestRate + sheet.after->largestRate);
  }
  return bound;
}

void addWake(const VesselWaves& waves, double t, SheetQuantities what, SampleStatus timeStatus,
             WakeTile& tile) {
  const WakeSheet& widest = waves.sheets.back();
  const double reach = 0.5 * widest.size();
  if (!tile.meets(widest.centre, reach)) return;
  if (timeStatus != SampleStatus::ok) tile.mark(timeStatus, widest.centre, reach);
  for (const WakeSheet& sheet : waves.sheets) {
    const SheetSampling sampling = samplingOf(sheet, t);
    const bool still = what == SheetQuantities::orbital && !sampling.potentialBefore;
    addSheet(sampling, still ? SheetQuantities::surface : what, tile.x, tile.y, tile.count,
             !tile.anyNan && tile.liesWithin(sheet.centre, 0.5 * sheet.size()), tile.sums);
    if (still) tile.mark(SampleStatus::noKinematics, widest.centre, reach);
    if (tile.liesWithin(sheet.centre, sheet.interior())) continue;
    for (std::size_t i = 0; i < tile.count; ++i) {
      if (tile.within(i, widest.centre, reach) && !tile.within(i, sheet.centre, sheet.interior())) {
        tile.status[i] |= SampleStatus::wakePartial;
      }
    }
  }
}

}  // namespace

DisturbanceState::DisturbanceState(std::vector<VesselWaves> wakes, const Water& water)
    : wakes_(std::move(wakes)), water_(water) {
  std::erase_if(wakes_, [](const VesselWaves& wake) { return wake.sheets.empty(); });
  for (const VesselWaves& wake : wakes_) {
    for (const WakeSheet& sheet : wake.sheets) {
      start_ = std::max(start_, sheet.start);
      end_ = std::min(end_, sheet.end);
    }
    heightBound_ += heightBoundOf(wake);
  }
}

void DisturbanceState::addTo(std::span<const glm::dvec2> points, double t,
                             std::span<SurfaceSample> out,
                             const SampleOptions& options) const noexcept {
  if (!std::isfinite(t)) return;
  const SheetQuantities what = quantitiesOf(options);
  const bool inTime = t >= start_ - timeRounding && t <= end_ + timeRounding;
  const SampleStatus timeStatus = inTime ? SampleStatus::ok : SampleStatus::wakeOutOfTime;
  const glm::dvec2 drift = water_.current * t;
  WakeTile tile;
  for (std::size_t first = 0; first < points.size(); first += pointsPerTile) {
    tile.begin(std::min(pointsPerTile, points.size() - first));
    for (std::size_t i = 0; i < tile.count; ++i) {
      tile.put(i, points[first + i].x - drift.x, points[first + i].y - drift.y);
    }
    for (const VesselWaves& waves : wakes_) {
      const bool own = options.excludeVessel != 0 && waves.vessel == options.excludeVessel;
      if (own) continue;
      addWake(waves, t, what, timeStatus, tile);
      const WakeSheet& widest = waves.sheets.back();
      tile.addBound(splineError * heightBoundOf(waves), widest.centre, 0.5 * widest.size());
    }
    for (std::size_t i = 0; i < tile.count; ++i) {
      const PointSums& sums = tile.sums[i];
      SurfaceSample& sample = out[first + i];
      sample.height += sums[wake::height];
      sample.bound += tile.bound[i];
      sample.status |= tile.status[i];
      if (what == SheetQuantities::height) continue;
      const glm::dvec2 slope(sums[wake::slopeX], sums[wake::slopeY]);
      sample.slope += slope;
      sample.verticalVelocity += sums[wake::rate] - glm::dot(water_.current, slope);
      if (what != SheetQuantities::orbital) continue;
      sample.orbitalVelocity +=
          glm::dvec3(sums[wake::velocityX], sums[wake::velocityY], sums[wake::rate]);
      if (has(tile.status[i], SampleStatus::noKinematics)) {
        sample.orbitalVelocity = glm::dvec3(std::numeric_limits<double>::quiet_NaN());
      }
    }
  }
}

void DisturbanceState::addTo(std::span<const double> x, std::span<const double> y, double t,
                             const Arrays& out, const SampleOptions& options) const noexcept {
  if (!std::isfinite(t)) return;
  const bool heightOnly = out.slopeX.empty() && out.slopeY.empty() && out.rate.empty();
  const SheetQuantities what = heightOnly ? SheetQuantities::height : SheetQuantities::surface;
  const glm::dvec2 drift = water_.current * t;
  WakeTile tile;
  for (std::size_t first = 0; first < x.size(); first += pointsPerTile) {
    tile.begin(std::min(pointsPerTile, x.size() - first));
    for (std::size_t i = 0; i < tile.count; ++i) {
      tile.put(i, x[first + i] - drift.x, y[first + i] - drift.y);
    }
    for (const VesselWaves& waves : wakes_) {
      const bool own = options.excludeVessel != 0 && waves.vessel == options.excludeVessel;
      if (!own) addWake(waves, t, what, SampleStatus::ok, tile);
    }
    for (std::size_t i = 0; i < tile.count; ++i) {
      const PointSums& sums = tile.sums[i];
      if (!out.height.empty()) out.height[first + i] += sums[wake::height];
      if (!out.slopeX.empty()) out.slopeX[first + i] += sums[wake::slopeX];
      if (!out.slopeY.empty()) out.slopeY[first + i] += sums[wake::slopeY];
      if (out.rate.empty()) continue;
      out.rate[first + i] += sums[wake::rate] -
                             static_cast<float>(water_.current.x) * sums[wake::slopeX] -
                             static_cast<float>(water_.current.y) * sums[wake::slopeY];
    }
  }
}

DisturbanceState::Motion DisturbanceState::motion(const VesselWaves& waves, glm::dvec2 point,
                                                  double t) const noexcept {
  const glm::dvec2 place = point - water_.current * t;
  PointSums sums{};
  Motion motion;
  motion.hasVelocity = true;
  for (const WakeSheet& sheet : waves.sheets) {
    const SheetSampling sampling = samplingOf(sheet, t);
    const bool moves = sampling.potentialBefore != nullptr;
    addSheet(sampling, moves ? SheetQuantities::orbital : SheetQuantities::surface, &place.x,
             &place.y, 1, false, &sums);
    motion.hasVelocity = motion.hasVelocity && moves;
  }
  motion.height = sums[wake::height];
  motion.rate = sums[wake::rate];
  motion.slope = {sums[wake::slopeX], sums[wake::slopeY]};
  motion.velocity = {sums[wake::velocityX], sums[wake::velocityY]};
  return motion;
}

std::size_t DisturbanceState::memoryBytes() const {
  std::set<const WakeGrid*> grids;
  for (const VesselWaves& wake : wakes_) {
    for (const WakeSheet& sheet : wake.sheets) {
      grids.insert(sheet.before.get());
      grids.insert(sheet.after.get());
    }
  }
  std::size_t bytes = 0;
  for (const WakeGrid* grid : grids) bytes += grid->memoryBytes();
  return bytes;
}

}  // namespace seaway
