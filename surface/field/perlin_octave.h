#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <limits>

#include "surface/field/lattice_hash.h"
#include "surface/field/octave.h"

namespace seaway {

/// Value and derivatives of an octave's noise at a point of the sea plane.
struct OctaveSample {
  double height = 0.0;
  glm::dvec2 slope{0.0};
  double verticalVelocity = 0.0;
};

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

  /// What is the same for all points of one time.
  struct AtTime {
    glm::dvec2 latticeShift;           ///< offset minus drift, cells
    LatticeSeeds slice[2];             ///< seeds of the time slices before and after t
    std::array<double, 2> weight;      ///< of the two slices
    std::array<double, 2> weightRate;  ///< their time derivatives, 1/s
  };
  AtTime at(double t) const noexcept;

  /// The octave at a point of the sea plane (m); SI units.
  OctaveSample sample(glm::dvec2 point, const AtTime& time) const noexcept;

  /// Largest rounding error of `sample().height` at distance |point| ≤ `reach` m and time t, m.
  double roundingBound(double reach, double t) const noexcept;

  /// Largest |n₃|/σ: the octave's bound in units of its standard deviation.
  static double peakFactor();

 private:
  double amplitude_;        // aᵢ/σ
  double cellsPerMetre_;
  double slicesPerSecond_;
  glm::dvec2 axis_;         // lattice x axis in the sea plane
  glm::dvec2 velocity_;     // vᵢ + U, m/s
  glm::dvec2 offset_;       // cells
  double timeOffset_;       // slices
  std::uint64_t sliceSeed_;
};

}  // namespace seaway
