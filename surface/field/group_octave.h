#pragma once

#include <cstdint>
#include <glm/vec2.hpp>

#include "surface/field/lattice_hash.h"
#include "surface/field/linear_coordinate.h"
#include "surface/field/octave.h"
#include "surface/field/octave_sample.h"

namespace seaway {

/// A group octave, or a regular wave, at one time: the same constants serve the reference and the
/// fast kernels.
struct GroupAtTime {
  LinearCoordinate along, across;  ///< envelope lattice, cells; all zero for a regular wave
  LinearCoordinate turns;          ///< carrier phase, turns
  LatticeSeeds seeds{};            ///< with the whole cells of the offsets folded in
  double amplitude = 0.0;          ///< m per unit of envelope
};

/// Reference evaluation of a group octave, double precision:
///
///   η = a [A(ξ) cos ψ + B(ξ) sin ψ],  ψ = k·(x − Ut) − ωt + φ,
///   ξ = ((ê∥·(x − Ut) − c_g t)/ℓ∥ + o₁, ê⊥·(x − Ut)/ℓ⊥ + o₂),  ω² = gk tanh kd,  c_g = dω/dk.
///
/// A and B are lattice noises from one hash a corner: each the difference of two pairs of its
/// nibbles, exact integers of variance 85. Corners are blended along each axis with weights
/// cos θ, sin θ, θ = ½π·fade: their squares add up to 1, so the variance is a² at every point and
/// time. A regular wave has A = √2, B = 0 everywhere. Pure, thread-safe, noexcept.
class GroupOctave {
 public:
  /// `sceneSeed` and `index` select φ, o and the lattice. `current` U m/s, `depth` m.
  GroupOctave(const Octave& octave, std::uint64_t sceneSeed, std::uint64_t index,
              glm::dvec2 current, double depth);

  GroupAtTime at(double t) const noexcept;

  /// Height, slope and ∂η/∂t at a point of the sea plane (m).
  OctaveSample sample(glm::dvec2 point, const GroupAtTime& time) const noexcept;

  /// Largest rounding error of `sample().height` at distance |point| ≤ `reach` m, m.
  double roundingBound(double reach) const noexcept;

  /// Largest |η| in units of the standard deviation.
  double peakFactor() const;

  glm::dvec2 direction() const { return direction_; }            ///< unit, where it goes
  double wavelength() const { return wavelength_; }              ///< of the carrier, m
  double angularFrequency() const { return angularFrequency_; }  ///< ω, rad/s, without current
  /// Horizontal orbital velocity at the surface per metre of height: ω coth kd along the wave, 1/s.
  glm::dvec2 orbitalVelocityPerHeight() const { return orbitalVelocityPerHeight_; }
  /// e^(−2kd): how much the bed is felt; 0 in deep water.
  double bedDecay() const { return bedDecay_; }

 private:
  bool regular_;
  double standardDeviation_;
  double angularFrequency_;
  double wavelength_;
  double bedDecay_;
  glm::dvec2 direction_, orbitalVelocityPerHeight_;
  LinearCoordinate along_, across_, turns_;  // at t = 0, offsets not reduced
  LatticeSeeds seeds_;
};

}  // namespace seaway
