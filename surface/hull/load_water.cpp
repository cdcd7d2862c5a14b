#include <algorithm>
#include <cmath>

#include "surface/hull/load_work.h"
#include "surface/water_kinematics.h"

namespace seaway {
namespace {

constexpr double waterViscosity = 1.19e-6;  // m²/s at 15 °C (ITTC 7.5-02-01-03)

/// How fast splashes, ripples and what layers take away die down with depth, 1/m: as in
/// sampleKinematics.
constexpr double changeDecay = pi;

bool isFinite(const glm::dvec3& v) { return std::isfinite(v.x + v.y + v.z); }

/// ITTC 1957 model–ship correlation line; flow slower than Re = 1000 is taken at that.
double skinFriction(const HullModel& hull, double speed) {
  if (hull.settings().coefficients.skinFriction) return *hull.settings().coefficients.skinFriction;
  const double reynolds = std::max(speed * hull.length() / waterViscosity, 1e3);
  const double line = std::log10(reynolds) - 2.0;
  return 0.075 / (line * line);
}

}  // namespace

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
  if (disturbed()) {
    water.extras().addTo(places, water.time(), surface, heights,
                         [&](auto some, auto samples, const SampleOptions& wanted) {
                           water.waves().sample(some, samples, wanted);
                         });
  }
  if (water.disturbances()) {
    water.disturbances()->addTo(places, water.time(), surface, heights);
  }
  result.leftOut = surface[0].error;
  result.status |= surface[0].status;
  if (!std::isfinite(surface[0].height)) return false;
  const double depth = water.waves().field().settings().depth;
  // Heights with extras are summed in another order there: rounding must not lift a point out.
  const double margin = disturbed() ? 1e-6 : 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i].z = std::max(std::min(points[i].z, surface[i].height - margin), -depth);
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

void LoadWork::sampleHeights() {
  const bool slopes = !scratch.slopeX_.empty();
  SampleOptions wanted = sampling;
  wanted.derivatives = slopes;
  const FieldAtTime::Arrays out{scratch.height_, scratch.slopeX_, scratch.slopeY_, {}};
  if (!disturbed()) return water.sample(scratch.x_, scratch.y_, out, wanted);
  water.waves().sample(scratch.x_, scratch.y_, out, wanted);
  addChanges();
  if (!water.disturbances()) return;
  water.disturbances()->addTo(scratch.x_, scratch.y_, water.time(),
                              {scratch.height_, scratch.slopeX_, scratch.slopeY_, {}}, wanted);
}

/// Adds what splashes, rain, ripples and layers change to heights and slopes of waves, and keeps
/// the change of heights.
void LoadWork::addChanges() {
  constexpr std::size_t most = 64;
  std::array<glm::dvec2, most> places;
  std::array<SurfaceSample, most> samples;
  const bool slopes = !scratch.slopeX_.empty();
  SampleOptions wanted = sampling;
  wanted.derivatives = slopes;
  const std::size_t all = scratch.height_.size();
  for (std::size_t first = 0; first < all; first += most) {
    const std::size_t count = std::min(most, all - first);
    for (std::size_t n = 0; n < count; ++n) {
      const std::size_t i = first + n;
      places[n] = {scratch.x_[i], scratch.y_[i]};
      samples[n] = {};
      samples[n].height = scratch.height_[i];
      if (slopes) samples[n].slope = {scratch.slopeX_[i], scratch.slopeY_[i]};
    }
    water.extras().addTo(std::span(places).first(count), water.time(),
                         std::span(samples).first(count), wanted,
                         [&](auto some, auto waves, const SampleOptions& asked) {
                           water.waves().sample(some, waves, asked);
                         });
    for (std::size_t n = 0; n < count; ++n) {
      const std::size_t i = first + n;
      const auto height = static_cast<float>(samples[n].height);
      scratch.change_[i] = height - scratch.height_[i];
      scratch.height_[i] = height;
      if (!slopes) continue;
      scratch.slopeX_[i] = static_cast<float>(samples[n].slope.x);
      scratch.slopeY_[i] = static_cast<float>(samples[n].slope.y);
    }
  }
}

void LoadWork::tellShore() {
  const WaterOutline* outline = water.outline();
  if (!outline) return;
  for (std::size_t i = 0; i < scratch.x_.size(); ++i) {
    if (outline->contains({scratch.x_[i], scratch.y_[i]})) continue;
    result.status |= SampleStatus::dry;
    return;
  }
}

/// Whether any of the first places, with what is in `depth_` still their depths below the
/// still-water level, lies in the terrain.
bool LoadWork::touchesGround(std::size_t count) const {
  const TerrainMap* terrain = water.terrain();
  if (!terrain) return false;
  for (std::size_t i = 0; i < count; ++i) {
    if (-scratch.depth_[i] < terrain->heightAt({scratch.x_[i], scratch.y_[i]})) return true;
  }
  return false;
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
  sampleHeights();
  tellShore();
  bool known = true, touches = false;
  std::size_t wet = 0;
  const double bed = -water.waves().field().settings().depth;
  touches |= touchesGround(vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const double height = scratch.height_[i];
    known &= height > bed;
    touches |= scratch.depth_[i] > -bed;
    scratch.depth_[i] += height;
    scratch.pressure_[i] = waterWeight * scratch.depth_[i];
    if (scratch.depth_[i] > 0.0) scratch.wet_[wet++] = static_cast<std::uint32_t>(i);
  }
  if (!known) return false;
  if (touches) result.status |= SampleStatus::belowBed;
  if (hull.settings().level == LoadLevel::meshDynamic) addDynamicPressure(wet);
  return true;
}

/// Replaces ρg(ζ − z) by ρg(head − z) at the wet vertices.
void LoadWork::addDynamicPressure(std::size_t wet) {
  const WaveField& waves = water.waves().field();
  if (!waves.lists().perlins.empty()) return;
  const bool calm = waves.octaves().empty() && !water.disturbances() && !disturbed();
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
    if (disturbed()) {
      head += static_cast<double>(scratch.change_[i]) *
              std::exp(changeDecay * static_cast<double>(scratch.stretched_[n]));
    }
    scratch.pressure_[i] += waterWeight * (head - scratch.height_[i]);
  }
}

}  // namespace seaway
