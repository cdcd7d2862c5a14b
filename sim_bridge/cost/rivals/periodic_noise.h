#pragma once

#include <cstdint>
#include <vector>

#include "sim_bridge/cost/rivals/texel_kernels.h"

namespace seaway::rivals {

/// A square of lattice noise at one time, repeated after `cells`, a power of two: PerlinOctave's
/// noise with unit variance, without rotation and drift.
class PeriodicNoise {
 public:
  PeriodicNoise(std::uint64_t seed, std::uint32_t cells, double boilTime, double t);

  /// In double, corner by corner; u and v in cells.
  double at(double u, double v) const;

  /// Adds value, derivatives by u and v times `perMetre`, and the rate, all times `amplitude`, at
  /// the centres of `texels`² texels.
  void addTo(std::vector<Texel>& out, std::uint32_t texels, double amplitude,
             double perMetre) const;

 private:
  struct Gradient {
    float x, y, rateX, rateY;  // of the two blended slices
  };
  const Gradient& corner(std::uint32_t i, std::uint32_t j) const {
    return gradients_[(j & (cells_ - 1)) * cells_ + (i & (cells_ - 1))];
  }

  std::uint32_t cells_;
  std::vector<Gradient> gradients_;
};

}  // namespace seaway::rivals
