#pragma once

#include <complex>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "surface/disturbance/hull_footprint.h"

namespace seaway {

/// A hull's spectrum Ĥ(k) for one depth of water, tabled in the body frame for k_x ≥ 0 (a real
/// footprint has Ĥ(−k) = conj Ĥ(k)), so that it can be looked up for any heading.
///
/// Bilinear in a spacing that turns the phase of the hull's farthest point by 0.15 rad: within 0.1
/// % of Ĥ(0) (tests/surface/disturbance/hull_footprint_test.cpp), more for hulls longer than some
/// 50 of the shortest waves, where the table stops growing at 8 MB.
class FootprintTable {
 public:
  /// Wave numbers up to `largest` rad/m along either axis.
  FootprintTable(const HullFootprint& hull, double depth, double largest);

  double spacing() const { return spacing_; }      ///< rad/m
  std::int32_t alongX() const { return alongX_; }  ///< intervals of k_x from 0
  std::int32_t alongY() const { return alongY_; }  ///< intervals of k_y either side of 0

  /// Real and imaginary parts in turn, m³; rows of alongX() + 1 entries from k_y = −alongY() up.
  const float* values() const { return reinterpret_cast<const float*>(values_.data()); }

  /// ∫∫H dA in m³ and the hull's largest distance from the body's origin, m.
  double volume() const { return volume_; }
  double extent() const { return extent_; }

  std::size_t memoryBytes() const { return values_.size() * sizeof(values_[0]); }

 private:
  double spacing_ = 0.0, volume_ = 0.0, extent_ = 0.0;
  std::int32_t alongX_ = 0, alongY_ = 0;
  std::vector<std::complex<float>> values_;
};

}  // namespace seaway
