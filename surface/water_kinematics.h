#pragma once

#include <glm/vec3.hpp>
#include <span>

#include "surface/field/wave_field.h"
#include "surface/water_surface.h"

namespace seaway {

/// Motion of the water at a point on or below the surface.
struct WaterKinematics {
  double surfaceHeight = 0.0;    ///< η above the point, m above the still-water level
  glm::dvec3 velocity{0.0};      ///< orbital velocity (east, north, up), m/s, without the current
  glm::dvec3 acceleration{0.0};  ///< its local rate of change in the water's frame, m/s²
  double dynamicPressure = 0.0;  ///< ρg Σ ηᵢ cosh k(z' + d)/cosh kd, Pa
  double pressure = 0.0;         ///< gauge: dynamic pressure − ρgz, Pa; 0 at the surface
  SampleStatus status = SampleStatus::ok;
};

/// Linear wave kinematics of group octaves and regular waves at `points` (sea plane; z above the
/// still-water level, m) at the time of `now`. `out` has at least the size of `points`.
///
/// Velocities are ηᵢωᵢ cosh k(z' + d)/sinh kd along the wave and Dηᵢ/Dt sinh k(z' + d)/sinh kd
/// upwards; accelerations follow with ∂/∂t → D/Dt and −ωᵢ²ηᵢ. The height is stretched to
/// z' = d(z − η)/(d + η), z − η in deep water, 0 at the actual surface (Wheeler 1970); so nothing
/// explodes in a crest and the pressure is zero at the surface. Exact to first order in steepness
/// and in an octave's bandwidth.
///
/// A point above the surface or in the bed, or where η falls to the bed, gets NaN and a status bit;
/// so do all points of a field with Perlin octaves. `options` leaves out octaves as in
/// FieldAtTime::sample, from the surface height too. Float in vectors of points: velocities within
/// 1e-5 of σω, pressures within 1e-5 ρgσ of the reference
/// (tests/surface/water_kinematics_test.cpp). Thread-safe, allocates nothing, gives the same bits
/// for any batch.
void sampleKinematics(const FieldAtTime& now, std::span<const glm::dvec3> points,
                      std::span<WaterKinematics> out, const SampleOptions& options = {}) noexcept;

/// The same for the whole surface: heights are stretched about waves and disturbances together, and
/// a wake's motion, known at the surface, decays with its mean wave number: exact at the surface,
/// an estimate below. SampleOptions::excludeVessel leaves out a vessel's own. So do splashes,
/// ripples and what smoothed water takes away, all as fast as waves of 2 m do.
void sampleKinematics(const SurfaceAtTime& now, std::span<const glm::dvec3> points,
                      std::span<WaterKinematics> out, const SampleOptions& options = {}) noexcept;

/// Pressure head of the disturbances at a point below the surface, m: their height there times its
/// decay with depth, as sampleKinematics has it. `stretched` ≤ 0 is Wheeler's height z', m.
double disturbanceHead(const SurfaceAtTime& now, glm::dvec2 point, double stretched,
                       std::uint32_t excludeVessel) noexcept;

/// The same as the first in double precision throughout, octave by octave as the equations read,
/// some 0.1 µs a point and octave: the truth that `sampleKinematics` is tested against.
void sampleKinematicsReference(const WaveField& waves, std::span<const glm::dvec3> points, double t,
                               std::span<WaterKinematics> out) noexcept;

}  // namespace seaway
