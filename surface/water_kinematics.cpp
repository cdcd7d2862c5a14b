#include "surface/water_kinematics.h"

#include <cmath>
#include <limits>

#include "surface/constants.h"

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

/// Height at a point, or what forbids kinematics there.
WaterKinematics atSurface(const WaveField& waves, const glm::dvec3& point, double t) {
  const glm::dvec2 place(point);
  SurfaceSample sample;
  waves.sampleReference(std::span(&place, 1), t, std::span(&sample, 1));
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
  return result;
}

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
  sum.acceleration +=
      glm::dvec3(along * rate, -omega * omega * part.height * decay.vertical);
  sum.dynamicPressure += seaWaterDensity * standardGravity * part.height * decay.pressure;
}

}  // namespace

void sampleKinematics(const WaveField& waves, std::span<const glm::dvec3> points, double t,
                      std::span<WaterKinematics> out) {
  const OctaveLists lists = waves.lists();
  for (std::size_t p = 0; p < points.size(); ++p) {
    out[p] = atSurface(waves, points[p], t);
    if (out[p].status != SampleStatus::ok) continue;
    for (const GroupOctave& octave : lists.groups) add(octave, waves, points[p], t, out[p]);
    for (const GroupOctave& octave : lists.regulars) add(octave, waves, points[p], t, out[p]);
    out[p].pressure =
        out[p].dynamicPressure - seaWaterDensity * standardGravity * points[p].z;
  }
}

}  // namespace seaway
