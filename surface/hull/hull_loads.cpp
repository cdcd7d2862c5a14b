#include "surface/hull/hull_loads.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "surface/hull/wet_triangle.h"
#include "surface/water_kinematics.h"

namespace seaway {
namespace {

constexpr double weightDensity = seaWaterDensity * standardGravity;  // N/m³
constexpr double waterViscosity = 1.19e-6;  // m²/s at 15 °C (ITTC 7.5-02-01-03)

bool isFinite(const glm::dvec3& v) { return std::isfinite(v.x + v.y + v.z); }

bool isFinite(const HullPose& pose) {
  const glm::dquat& q = pose.worldFromBody;
  return isFinite(pose.position) && isFinite(pose.velocity) && isFinite(pose.angularVelocity) &&
         std::isfinite(q.w + q.x + q.y + q.z);
}

Load notFinite() {
  const glm::dvec3 nan(std::numeric_limits<double>::quiet_NaN());
  return {nan, nan};
}

HullLoads unknown(SampleStatus status) {
  HullLoads result;
  result.buoyancy = result.drag = result.radiation = result.wind = notFinite();
  result.waterAcceleration = glm::dvec3(std::numeric_limits<double>::quiet_NaN());
  result.status = status;
  return result;
}

/// ITTC 1957 model–ship correlation line; flow slower than Re = 1000 is taken at that.
double skinFriction(const HullModel& hull, double speed) {
  if (hull.settings().coefficients.skinFriction) return *hull.settings().coefficients.skinFriction;
  const double reynolds = std::max(speed * hull.length() / waterViscosity, 1e3);
  const double line = std::log10(reynolds) - 2.0;
  return 0.075 / (line * line);
}

/// Sums of the body frame.
struct BodySums {
  Load buoyancy, drag, wind;
  double volume = 0.0, wetted = 0.0;

  /// Pressure that is linear over a panel: −∫ p n dA and −∫ p r × n dA.
  void press(const HullModel::Panel& panel, double pa, double pb, double pc) {
    buoyancy.force -= ((pa + pb + pc) * (1.0 / 3.0)) * panel.area;
    buoyancy.moment -= pa * panel.moments[0] + pb * panel.moments[1] + pc * panel.moments[2];
  }

  /// The same over a triangle.
  void press(const glm::dvec3& area, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
             double pa, double pb, double pc) {
    const double sum = pa + pb + pc;
    const glm::dvec3 arm = (sum * (a + b + c) + pa * a + pb * b + pc * c) * (1.0 / 12.0);
    buoyancy.force -= (sum / 3.0) * area;
    buoyancy.moment -= glm::cross(arm, area);
  }
};

}  // namespace

/// One evaluation: what loads() and its parts share.
struct LoadWork {
  const HullModel& hull;
  const HullPose& pose;
  const SurfaceAtTime& water;
  LoadScratch& scratch;
  const LoadOptions& options;
  SampleOptions sampling;
  glm::dmat3 worldFromBody;
  glm::dmat3 bodyFromWorld;
  BodySums sums;
  HullLoads result;

  // The body's motion in its own axes, and the water's at the probes.
  glm::dvec3 velocity{0.0}, turning{0.0};
  std::array<glm::dvec3, HullModel::probes> flow{}, slip{};  // of the water, of the body in it
  std::array<double, HullModel::probes> rise{};              // of the water, m/s
  glm::dvec3 wind{0.0};
  double friction = 0.0;
  bool flows = false;

  LoadWork(const HullModel& itsHull, const HullPose& itsPose, const SurfaceAtTime& itsWater,
           LoadScratch& itsScratch, const LoadOptions& itsOptions)
      : hull(itsHull),
        pose(itsPose),
        water(itsWater),
        scratch(itsScratch),
        options(itsOptions),
        worldFromBody(glm::mat3_cast(itsPose.worldFromBody)),
        bodyFromWorld(glm::transpose(worldFromBody)) {
    sampling.shortestWavelength = options.shortestWavelength.value_or(hull.shortestWavelength());
    sampling.derivatives = false;
    sampling.excludeVessel = options.ownWake;
    velocity = bodyFromWorld * pose.velocity;
    turning = bodyFromWorld * pose.angularVelocity;
  }

  void resize(std::size_t points, bool slopes) {
    for (auto* values : {&scratch.x_, &scratch.y_, &scratch.depth_, &scratch.pressure_}) {
      values->resize(points);
    }
    for (auto* values : {&scratch.height_, &scratch.stretched_, &scratch.head_}) {
      values->resize(points);
    }
    scratch.slopeX_.resize(slopes ? points : 0);
    scratch.slopeY_.resize(slopes ? points : 0);
    scratch.place_.resize(points);
    scratch.wet_.resize(points);
  }

  bool probeWater();
  bool submergeVertices();
  void addDynamicPressure(std::size_t wet);
  void pressPanels();
  struct WetPart {
    double share, meanDepth;
  };
  WetPart pressCut(const HullModel::Panel& panel, const Wetness& wetness);
  void drag(const HullModel::Panel& panel, double wetPart, bool cut);
  void blow(const HullModel::Panel& panel, double dryPart);
  void pushColumns();
  void dragColumns();
  void radiate();
  HullLoads finish();
};

/// Water velocity and acceleration at the probes, and the friction coefficient that follows.
bool LoadWork::probeWater() {
  std::array<glm::dvec2, HullModel::probes> places;
  std::array<glm::dvec3, HullModel::probes> points;
  std::array<SurfaceSample, HullModel::probes> surface;
  std::array<WaterKinematics, HullModel::probes> motion;
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i] = pose.position + worldFromBody * hull.probePlaces()[i];
    places[i] = glm::dvec2(points[i]);
  }
  SampleOptions heights = sampling;
  water.waves().sample(places, surface, heights);
  if (water.disturbances()) {
    water.disturbances()->addTo(places, water.time(), surface, heights);
  }
  result.leftOut = surface[0].error;
  result.status |= surface[0].status;
  if (!std::isfinite(surface[0].height)) return false;
  const double depth = water.waves().field().settings().depth;
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i].z = std::max(std::min(points[i].z, surface[i].height), -depth);
  }
  sampleKinematics(water, points, motion, sampling);
  const glm::dvec3 current(water.waves().field().settings().current, 0.0);
  double fastest = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool known = isFinite(motion[i].velocity);
    if (!known) result.status |= SampleStatus::noKinematics;
    const glm::dvec3 own = known ? motion[i].velocity : glm::dvec3(0.0);
    rise[i] = own.z;
    flow[i] = bodyFromWorld * (own + current);
    if (known) result.waterAcceleration += motion[i].acceleration / double(HullModel::probes);
    slip[i] = velocity - flow[i];
    fastest = std::max(fastest, glm::length(slip[i]));
  }
  flows = fastest > 0.0 || glm::length(turning) > 0.0;
  friction = skinFriction(hull, fastest);
  if (options.wind) wind = bodyFromWorld * glm::dvec3(*options.wind, 0.0);
  return true;
}

/// Places of the vertices and their depths below the sea above them; false where the sea is not
/// known there.
bool LoadWork::submergeVertices() {
  const auto& vertices = hull.mesh().vertices;
  resize(vertices.size(), false);
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const glm::dvec3 place = pose.position + worldFromBody * vertices[i];
    scratch.x_[i] = place.x;
    scratch.y_[i] = place.y;
    scratch.depth_[i] = -place.z;
  }
  water.sample(scratch.x_, scratch.y_, {scratch.height_, {}, {}, {}}, sampling);
  bool known = true;
  std::size_t wet = 0;
  const double bed = -water.waves().field().settings().depth;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const double height = scratch.height_[i];
    known &= height > bed;
    scratch.depth_[i] += height;
    scratch.pressure_[i] = weightDensity * scratch.depth_[i];
    if (scratch.depth_[i] > 0.0) scratch.wet_[wet++] = static_cast<std::uint32_t>(i);
  }
  if (!known) return false;
  if (hull.settings().level == LoadLevel::meshDynamic) addDynamicPressure(wet);
  return true;
}

/// Replaces ρg(ζ − z) by ρg(head − z) at the wet vertices.
void LoadWork::addDynamicPressure(std::size_t wet) {
  const WaveField& waves = water.waves().field();
  if (!waves.lists().perlins.empty()) return;
  const bool calm = waves.octaves().empty() && !water.disturbances();
  if (calm) return;
  const double bed = waves.settings().depth;
  for (std::size_t n = 0; n < wet; ++n) {
    const std::uint32_t i = scratch.wet_[n];
    const double below = -scratch.depth_[i], height = scratch.height_[i];
    const double stretched = std::isinf(bed) ? below : std::max(bed * below / (bed + height), -bed);
    scratch.place_[n] = {scratch.x_[i], scratch.y_[i]};
    scratch.stretched_[n] = static_cast<float>(stretched);
  }
  for (std::size_t first = 0; first < wet; first += pointsPerTile) {
    const std::size_t count = std::min(pointsPerTile, wet - first);
    water.waves().sampleBelow(std::span(scratch.place_).subspan(first, count),
                              std::span(scratch.stretched_).subspan(first, count),
                              {std::span(scratch.head_).subspan(first, count), {}, {}}, sampling);
  }
  for (std::size_t n = 0; n < wet; ++n) {
    const std::uint32_t i = scratch.wet_[n];
    double head = scratch.head_[n];
    if (water.disturbances()) {
      head += disturbanceHead(water, scratch.place_[n], scratch.stretched_[n], options.ownWake);
    }
    scratch.pressure_[i] += weightDensity * (head - scratch.height_[i]);
  }
}

/// Drag on the wet part of a panel.
void LoadWork::drag(const HullModel::Panel& panel, double wetPart, bool cut) {
  const HullCoefficients& c = hull.settings().coefficients;
  const glm::dvec3 u =
      slip[static_cast<std::size_t>(panel.probe)] + glm::cross(turning, panel.middle);
  const double normal = glm::dot(u, panel.normal);
  const double along = std::sqrt(std::max(glm::dot(u, u) - normal * normal, 0.0));
  double push = c.formDrag * std::abs(normal) * normal - friction * along * normal;
  if (cut && normal > 0.0) push += c.slamming * normal * normal;
  const glm::dvec3 force = (-0.5 * seaWaterDensity * wetPart * panel.size) *
                           (push * panel.normal + (friction * along) * u);
  sums.drag.force += force;
  sums.drag.moment += glm::cross(panel.middle, force);
}

/// Wind on the dry part of a panel.
void LoadWork::blow(const HullModel::Panel& panel, double dryPart) {
  const glm::dvec3 u = velocity + glm::cross(turning, panel.middle) - wind;
  const double normal = glm::dot(u, panel.normal);
  const glm::dvec3 force = -0.5 * airDensity * hull.settings().coefficients.windDrag *
                           std::abs(normal) * normal * dryPart * panel.size * panel.normal;
  sums.wind.force += force;
  sums.wind.moment += glm::cross(panel.middle, force);
}

/// Pressure on the wet part of a panel that the surface cuts; that part, and the mean depth on it.
LoadWork::WetPart LoadWork::pressCut(const HullModel::Panel& panel, const Wetness& wetness) {
  const auto& vertices = hull.mesh().vertices;
  const std::uint32_t i = panel.corners[wetness.lone], j = panel.corners[(wetness.lone + 1) % 3],
                      k = panel.corners[(wetness.lone + 2) % 3];
  const glm::dvec3 n = vertices[i] + wetness.next * (vertices[j] - vertices[i]);
  const glm::dvec3 m = vertices[i] + wetness.before * (vertices[k] - vertices[i]);
  const auto& pressure = scratch.pressure_;
  const auto& depth = scratch.depth_;
  const double loneShare = wetness.next * wetness.before;
  if (wetness.wet == 1) {
    sums.press(loneShare * panel.area, vertices[i], n, m, pressure[i], 0.0, 0.0);
    return {loneShare, depth[i] / 3.0};
  }
  // Triangles n, j, k and n, k, m: the first has 1 − next of the whole.
  const double whole = 1.0 - loneShare, first = 1.0 - wetness.next, second = whole - first;
  sums.press(first * panel.area, n, vertices[j], vertices[k], 0.0, pressure[j], pressure[k]);
  sums.press(second * panel.area, n, vertices[k], m, 0.0, pressure[k], 0.0);
  return {whole,
          (first * (depth[j] + depth[k]) + second * depth[k]) / (3.0 * std::max(whole, 1e-300))};
}

void LoadWork::pressPanels() {
  const glm::dvec3 up = bodyFromWorld[2];
  const auto& depth = scratch.depth_;
  const auto& pressure = scratch.pressure_;
  for (const HullModel::Panel& panel : hull.panels()) {
    const std::uint32_t i = panel.corners.x, j = panel.corners.y, k = panel.corners.z;
    const Wetness wetness({depth[i], depth[j], depth[k]});
    if (wetness.wet == 0) {
      if (options.wind) blow(panel, 1.0);
      continue;
    }
    WetPart wet{1.0, (depth[i] + depth[j] + depth[k]) * (1.0 / 3.0)};
    if (wetness.wet == 3) {
      sums.press(panel, pressure[i], pressure[j], pressure[k]);
    } else {
      wet = pressCut(panel, wetness);
      if (options.wind) blow(panel, 1.0 - wet.share);
    }
    sums.volume -= wet.share * wet.meanDepth * glm::dot(panel.area, up);
    sums.wetted += wet.share * panel.size;
    if (flows) drag(panel, wet.share, wetness.wet != 3);
  }
}

/// ρg A ℓ (−∇η, 1) at the middle of a column's wet length ℓ: pressure grows along the surface's
/// normal, to first order for waves longer than the hull is deep.
void LoadWork::pushColumns() {
  const auto& columns = hull.columns();
  resize(columns.size(), true);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const glm::dvec3 place =
        pose.position + worldFromBody * glm::dvec3(columns[i].place, -hull.restHeight());
    scratch.x_[i] = place.x;
    scratch.y_[i] = place.y;
  }
  SampleOptions slopes = sampling;
  slopes.derivatives = true;
  water.sample(scratch.x_, scratch.y_, {scratch.height_, scratch.slopeX_, scratch.slopeY_, {}},
               slopes);
  const glm::dvec3 up = worldFromBody[2];
  const double steepness = std::max(std::abs(up.z), 1e-3);  // height of a column per metre of it
  Load world;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const MeshColumn& column = columns[i];
    const double lowEnd = up.z >= 0.0 ? column.low : column.high;
    const glm::dvec3 low = worldFromBody * glm::dvec3(column.place, lowEnd);
    const double under = scratch.height_[i] - (pose.position.z + low.z);
    const double wet = std::clamp(under / steepness, 0.0, column.high - column.low);
    const double volume = column.area * wet;
    const glm::dvec3 arm = low + (up.z >= 0.0 ? 0.5 : -0.5) * wet * up;
    const glm::dvec3 force =
        weightDensity * volume * glm::dvec3(-scratch.slopeX_[i], -scratch.slopeY_[i], 1.0);
    world.force += force;
    world.moment += glm::cross(arm, force);
    sums.volume += volume;
  }
  sums.buoyancy = {bodyFromWorld * world.force, bodyFromWorld * world.moment};
}

/// Drag on the sides of the box about the wet part, with the mean flow.
void LoadWork::dragColumns() {
  const HullCoefficients& c = hull.settings().coefficients;
  const glm::dvec3 size = hull.bounds().size();
  const double draft =
      std::min(size.z, sums.volume / std::max(hull.atRest().waterplaneArea, 1e-300));
  glm::dvec3 mean(0.0);
  for (const glm::dvec3& each : flow) mean += each / double(HullModel::probes);
  const glm::dvec3 u = velocity - mean;
  const glm::dvec3 sides(size.y * draft, size.x * draft, hull.atRest().waterplaneArea);
  const double wetted = draft > 0.0 ? hull.atRest().wettedArea : 0.0;
  const glm::dvec3 force =
      -0.5 * seaWaterDensity *
      (2.0 * c.formDrag * sides * glm::abs(u) * u + friction * wetted * glm::length(u) * u);
  sums.drag = {force, glm::cross(hull.atRest().centre, force)};
}

/// Linear damping of motion relative to the water, which rises by its mean over the hull and turns
/// with its tilt along and across it.
void LoadWork::radiate() {
  const double share = std::min(1.0, sums.volume / hull.atRest().volume);
  for (std::size_t i = 0; i < 6; ++i) result.addedMass[i] = share * hull.addedMass()[i];
  const glm::dvec3& damping = hull.damping();
  double mean = 0.0, pitching = 0.0, rolling = 0.0, xx = 0.0, yy = 0.0;
  const glm::dvec3 middle = hull.bounds().middle();
  for (std::size_t i = 0; i < rise.size(); ++i) {
    const glm::dvec3 arm = hull.probePlaces()[i] - middle;
    mean += rise[i] / double(HullModel::probes);
    pitching += arm.x * rise[i];
    rolling += arm.y * rise[i];
    xx += arm.x * arm.x;
    yy += arm.y * arm.y;
  }
  const glm::dvec3& gravity = hull.settings().centreOfGravity;
  const glm::dvec3 current(water.waves().field().settings().current, 0.0);
  const glm::dvec3 own = velocity + glm::cross(turning, gravity);
  const glm::dvec3 carried = bodyFromWorld * (current + glm::dvec3(0.0, 0.0, mean));
  const glm::dvec3 force(0.0, 0.0, -share * damping.x * (own.z - carried.z));
  // Water that rises forward turns the bow up: about −y.
  const glm::dvec3 couple(-share * damping.y * (turning.x - rolling / yy),
                          -share * damping.z * (turning.y + pitching / xx), 0.0);
  result.radiation = {worldFromBody * force, worldFromBody * (couple + glm::cross(gravity, force))};
}

HullLoads LoadWork::finish() {
  const auto inWorld = [&](const Load& load, double factor) {
    return Load{worldFromBody * (factor * load.force), worldFromBody * (factor * load.moment)};
  };
  result.buoyancy = inWorld(sums.buoyancy, hull.volumeFactor());
  result.drag = inWorld(sums.drag, 1.0);
  result.wind = inWorld(sums.wind, 1.0);
  result.submergedVolume = hull.volumeFactor() * sums.volume;
  result.wettedArea = sums.wetted;
  return result;
}

HullLoads loads(const HullModel& hull, const HullPose& pose, const SurfaceAtTime& water,
                LoadScratch& scratch, const LoadOptions& options) {
  if (!isFinite(pose) || !std::isfinite(water.time())) return unknown(SampleStatus::notFinite);
  LoadWork work(hull, pose, water, scratch, options);
  if (!work.probeWater()) return unknown(work.result.status);
  if (hull.settings().level == LoadLevel::columns) {
    work.pushColumns();
    if (work.flows) work.dragColumns();
  } else {
    if (!work.submergeVertices()) return unknown(work.result.status | SampleStatus::belowBed);
    work.pressPanels();
  }
  work.radiate();
  return work.finish();
}

HullLoads loads(const HullModel& hull, const HullPose& pose, const WaterSurface& water, double t,
                LoadScratch& scratch, const LoadOptions& options) {
  if (scratch.water_) {
    scratch.water_->moveTo(water, t);
  } else {
    scratch.water_.emplace(water.at(t));
  }
  return loads(hull, pose, *scratch.water_, scratch, options);
}

void loadsInParallel(std::span<const PlacedHull> hulls, const SurfaceAtTime& water,
                     std::span<HullLoads> out, std::span<LoadScratch> scratch) {
  tbb::parallel_for(std::size_t{0}, hulls.size(), [&](std::size_t i) {
    out[i] = loads(*hulls[i].model, hulls[i].pose, water, scratch[i], hulls[i].options);
  });
}

std::size_t LoadScratch::memoryBytes() const {
  return (x_.capacity() + y_.capacity() + depth_.capacity() + pressure_.capacity()) *
             sizeof(double) +
         (height_.capacity() + slopeX_.capacity() + slopeY_.capacity() + stretched_.capacity() +
          head_.capacity()) *
             sizeof(float) +
         place_.capacity() * sizeof(glm::dvec2) + wet_.capacity() * sizeof(std::uint32_t);
}

}  // namespace seaway
