#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>

#include "surface/field/linear_coordinate.h"
#include "surface/field/octave.h"
#include "surface/field/octave_sample.h"

namespace seaway {

/// Reference evaluation of a Perlin octave (Johanson 2004, "Generating waves"):
///
///   ηᵢ(x, t) = aᵢ n₃(Rᵢ(x − (vᵢ + U) t)/λᵢ + o, t/τᵢ + o_t) / σ
///
/// n₃ is lattice noise in three dimensions, the third being time. Across the plane it is gradient
/// noise with quintic interpolation; gradients are two bytes of the corner's hash, centred: exact
/// in integers. In time, two slices are blended with weights cos θ and sin θ, θ = ½π·fade: their
/// squares add up to 1, so the variance is the same at every instant, and since the gradients have
/// no time component the octave's band is narrower than that of isotropic gradient noise (relative
/// residual of a Pierson–Moskowitz fit 0.13 instead of 0.25). σ is the root mean square over the
/// cell, so aᵢ is the octave's standard deviation.
///
/// Double precision, written for clearness: this is the truth for faster kernels. Pure,
/// thread-safe, noexcept.
class PerlinOctave {
 public:
  /// `sceneSeed` and `index` select rotation, offsets and lattice seeds. `current` m/s.
  PerlinOctave(const Octave& octave, std::uint64_t sceneSeed, std::uint64_t index,
               glm::dvec2 current);

  /// What is the same for all points of one time: the same constants serve the fast kernels.
  struct AtTime {
    LinearCoordinate first, second;    ///< lattice coordinates, cells
    LatticeSeeds slice[2];             ///< of the time slices before and after t
    std::array<double, 2> weight;      ///< of the two slices
    std::array<double, 2> weightRate;  ///< their time derivatives, 1/s
    double amplitude;                  ///< m per unit of noise
  };
  AtTime at(double t) const noexcept;

  /// Height, slope and ∂η/∂t at a point of the sea plane (m).
  OctaveSample sample(glm::dvec2 point, const AtTime& time) const noexcept;

  /// Largest rounding error of `sample().height` at distance |point| ≤ `reach` m, m.
  double roundingBound(double reach) const noexcept;

  double wavelength() const { return wavelength_; }  ///< dominant, m

  /// Largest |n₃|/σ: the octave's bound in units of its standard deviation.
  static double peakFactor();

 private:
  double amplitude_;  // aᵢ/σ
  double wavelength_;
  LinearCoordinate first_, second_;  // at t = 0, offsets not reduced
  LinearCoordinate slices_;
  std::uint64_t sliceSeed_;
};

}  // namespace seaway
