#include "surface/water_kinematics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "surface/constants.h"
#include "surface/dispersion.h"

namespace seaway {
namespace {

/// Decay with depth of horizontal and vertical velocity and of pressure, relative to ηω, Dη/Dt and
/// ρgη, at stretched height z' ≤ 0. Exponentials of negative numbers only: nothing overflows.
struct DepthDecay {
  double horizontal, vertical, pressure;

  DepthDecay(double k, double depth, double stretched) {
    const double decay = std::exp(k * stretched);
    const double bedSum = std::isinf(depth) ? 0.0 : std::exp(-2.0 * k * (stretched + depth));
    const double bedDifference =
        std::isinf(depth) ? 1.0 : -std::expm1(-2.0 * k * (stretched + depth));
    const double sinhLike = std::isinf(depth) ? 1.0 : -std::expm1(-2.0 * k * depth);
    const double coshLike = std::isinf(depth) ? 1.0 : 1.0 + std::exp(-2.0 * k * depth);
    horizontal = decay * (1.0 + bedSum) / sinhLike;
    vertical = decay * bedDifference / sinhLike;
    pressure = decay * (1.0 + bedSum) / coshLike;
  }
};

double stretchedHeight(double z, double surface, double depth) {
  return std::isinf(depth) ? z - surface : depth * (z - surface) / (depth + surface);
}

WaterKinematics invalid(double surface, SampleStatus status) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  return {surface, glm::dvec3(nan), glm::dvec3(nan), nan, nan, status};
}

/// What a point is given where the surface above it is `sample`: a height to stretch, or what
/// forbids kinematics there.
WaterKinematics under(const SurfaceSample& sample, const WaveField& waves,
                      const glm::dvec3& point) noexcept {
  const double depth = waves.settings().depth;
  if (std::isnan(sample.height)) return invalid(sample.height, sample.status);
  if (!std::isfinite(point.z)) return invalid(sample.height, SampleStatus::notFinite);
  if (!waves.lists().perlins.empty()) return invalid(sample.height, SampleStatus::noKinematics);
  if (sample.height <= -depth || point.z < -depth) {
    return invalid(sample.height, SampleStatus::belowBed);
  }
  if (point.z > sample.height) return invalid(sample.height, SampleStatus::aboveSurface);
  WaterKinematics result;
  result.surfaceHeight = sample.height;
  result.status = sample.status;
  return result;
}

/// Makes points in the ground invalid, and those of water that ground stands above.
void markBelowGround(const TerrainMap& terrain, std::span<const glm::dvec3> points,
                     std::span<WaterKinematics> out) noexcept {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double ground = terrain.heightAt(glm::dvec2(points[i]));
    if (points[i].z < ground || out[i].surfaceHeight <= ground) {
      out[i] = invalid(out[i].surfaceHeight, SampleStatus::belowBed);
    }
  }
}

constexpr double weightDensity = seaWaterDensity * standardGravity;  // N/m³

void add(const GroupOctave& octave, const WaveField& waves, const glm::dvec3& point, double t,
         WaterKinematics& sum) {
  const double depth = waves.settings().depth;
  const OctaveSample part = octave.sample(glm::dvec2(point), octave.at(t));
  const double rate =
      part.verticalVelocity + glm::dot(waves.settings().current, part.slope);  // Dη/Dt
  const double omega = octave.angularFrequency();
  const DepthDecay decay(2.0 * pi / octave.wavelength(), depth,
                         stretchedHeight(point.z, sum.surfaceHeight, depth));
  const glm::dvec2 along = omega * decay.horizontal * octave.direction();
  sum.velocity += glm::dvec3(along * part.height, rate * decay.vertical);
  sum.acceleration += glm::dvec3(along * rate, -omega * omega * part.height * decay.vertical);
  sum.dynamicPressure += weightDensity * part.height * decay.pressure;
}

/// Adds the motion of one vessel's waves at a point in the water.
void add(const DisturbanceState& state, const VesselWaves& wake, double depth, double t,
         const glm::dvec3& point, double stretched, WaterKinematics& sum) {
  const DisturbanceState::Motion motion = state.motion(wake, glm::dvec2(point), t);
  const double k = wake.meanWaveNumber;
  if (!(k > 0.0)) return;
  const DepthDecay decay(k, depth, stretched);
  const double omega = angularFrequency(k, depth);
  sum.dynamicPressure += weightDensity * motion.height * decay.pressure;
  if (!motion.hasVelocity) {
    sum.velocity = sum.acceleration = glm::dvec3(std::numeric_limits<double>::quiet_NaN());
    sum.status |= SampleStatus::noKinematics;
    return;
  }
  sum.velocity +=
      glm::dvec3(glm::dvec2(motion.velocity) * decay.pressure, motion.rate * decay.vertical);
  // ∂u/∂t = −g∇η at the surface.
  sum.acceleration += glm::dvec3(-standardGravity * glm::dvec2(motion.slope) * decay.pressure,
                                 -omega * omega * motion.height * decay.vertical);
}

/// What splashes, rain, ripples and damped waves change at the surface: known there alone.
struct SurfaceChange {
  double height = 0.0;
  glm::dvec3 velocity{0.0};
};

/// How fast that dies down with depth, 1/m: as waves of 2 m do.
constexpr double changeDecay = pi;

/// Adds the extras to heights of `surface` and notes what they change.
void addExtras(const FieldAtTime& now, const SurfaceExtras& extras,
               std::span<const glm::dvec2> points, std::span<SurfaceSample> surface,
               std::span<SurfaceChange> change, SampleOptions options) noexcept {
  std::array<SurfaceSample, pointsPerTile> before, after;
  const std::size_t count = points.size();
  options.derivatives = options.orbitalVelocity = true;
  now.sample(points, std::span(before.data(), count), options);
  after = before;
  extras.addTo(points, now.time(), std::span(after.data(), count), options,
               [&](auto some, auto samples, const SampleOptions& wanted) {
                 now.sample(some, samples, wanted);
               });
  for (std::size_t i = 0; i < count; ++i) {
    change[i] = {after[i].height - before[i].height,
                 after[i].orbitalVelocity - before[i].orbitalVelocity};
    surface[i].height += change[i].height;
  }
}

/// Kinematics of up to a tile of points.
void sampleTile(const FieldAtTime& now, const DisturbanceState* disturbances,
                const SurfaceExtras* extras, std::span<const glm::dvec3> points,
                std::span<WaterKinematics> out, const SampleOptions& options) noexcept {
  const WaveField& waves = now.field();
  const std::size_t count = points.size();
  std::array<glm::dvec2, pointsPerTile> places;
  std::array<SurfaceSample, pointsPerTile> surface;
  std::array<float, pointsPerTile> stretched, head;
  std::array<glm::vec3, pointsPerTile> velocity, acceleration;
  for (std::size_t i = 0; i < count; ++i) places[i] = glm::dvec2(points[i]);
  const std::span<const glm::dvec2> at(places.data(), count);
  SampleOptions heights = options;
  heights.derivatives = heights.orbitalVelocity = false;
  now.sample(at, std::span(surface.data(), count), heights);
  std::array<SurfaceChange, pointsPerTile> change;
  if (extras) {
    addExtras(now, *extras, at, std::span(surface.data(), count), std::span(change.data(), count),
              options);
  }
  if (disturbances) {
    disturbances->addTo(at, now.time(), std::span(surface.data(), count), heights);
  }
  for (std::size_t i = 0; i < count; ++i) {
    out[i] = under(surface[i], waves, points[i]);
    const double z = stretchedHeight(points[i].z, surface[i].height, waves.settings().depth);
    stretched[i] = std::isnan(out[i].pressure) ? 0.0f : static_cast<float>(z);
  }
  now.sampleBelow(at, std::span(stretched.data(), count), {head, velocity, acceleration}, heights);
  for (std::size_t i = 0; i < count; ++i) {
    if (std::isnan(out[i].pressure)) continue;
    out[i].velocity = velocity[i];
    out[i].acceleration = acceleration[i];
    out[i].dynamicPressure = weightDensity * head[i];
    if (extras) {
      const double left = std::exp(changeDecay * static_cast<double>(stretched[i]));
      out[i].dynamicPressure += weightDensity * change[i].height * left;
      out[i].velocity += change[i].velocity * left;
    }
    if (disturbances) {
      for (const VesselWaves& wake : disturbances->wakes()) {
        if (options.excludeVessel != 0 && wake.vessel == options.excludeVessel) continue;
        add(*disturbances, wake, waves.settings().depth, now.time(), points[i], stretched[i],
            out[i]);
      }
    }
    out[i].pressure = out[i].dynamicPressure - weightDensity * points[i].z;
  }
}

}  // namespace

void sampleKinematics(const FieldAtTime& now, std::span<const glm::dvec3> points,
                      std::span<WaterKinematics> out, const SampleOptions& options) noexcept {
  for (std::size_t first = 0; first < points.size(); first += pointsPerTile) {
    const std::size_t count = std::min(pointsPerTile, points.size() - first);
    sampleTile(now, nullptr, nullptr, points.subspan(first, count), out.subspan(first, count),
               options);
  }
}

void sampleKinematics(const SurfaceAtTime& now, std::span<const glm::dvec3> points,
                      std::span<WaterKinematics> out, const SampleOptions& options) noexcept {
  const SurfaceExtras* extras =
      now.extras().events || now.extras().detail ? &now.extras() : nullptr;
  for (std::size_t first = 0; first < points.size(); first += pointsPerTile) {
    const std::size_t count = std::min(pointsPerTile, points.size() - first);
    sampleTile(now.waves(), now.disturbances(), extras, points.subspan(first, count),
               out.subspan(first, count), options);
  }
  if (now.terrain()) markBelowGround(*now.terrain(), points, out);
}

double disturbanceHead(const SurfaceAtTime& now, glm::dvec2 point, double stretched,
                       std::uint32_t excludeVessel) noexcept {
  const DisturbanceState* state = now.disturbances();
  if (!state) return 0.0;
  double head = 0.0;
  for (const VesselWaves& wake : state->wakes()) {
    if (excludeVessel != 0 && wake.vessel == excludeVessel) continue;
    if (!(wake.meanWaveNumber > 0.0)) continue;
    const DepthDecay decay(wake.meanWaveNumber, now.waves().field().settings().depth, stretched);
    head += state->motion(wake, point, now.time()).height * decay.pressure;
  }
  return head;
}

void sampleKinematicsReference(const WaveField& waves, std::span<const glm::dvec3> points, double t,
                               std::span<WaterKinematics> out) noexcept {
  const OctaveLists lists = waves.lists();
  for (std::size_t p = 0; p < points.size(); ++p) {
    const glm::dvec2 place(points[p]);
    SurfaceSample sample;
    waves.sampleReference(std::span(&place, 1), t, std::span(&sample, 1));
    out[p] = under(sample, waves, points[p]);
    if (std::isnan(out[p].pressure)) continue;
    for (const GroupOctave& octave : lists.groups) add(octave, waves, points[p], t, out[p]);
    for (const GroupOctave& octave : lists.regulars) add(octave, waves, points[p], t, out[p]);
    out[p].pressure = out[p].dynamicPressure - weightDensity * points[p].z;
  }
}

}  // namespace seaway
