#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "surface/water_surface.h"

namespace seaway::bridge {

/// Where samples go: as many places as points, null where not wanted. `Real` is double or float.
template <class Real>
struct WaveArrays {
  double* height = nullptr;
  Real *slopeEast = nullptr, *slopeNorth = nullptr, *verticalVelocity = nullptr;
  Real *error = nullptr, *bound = nullptr;
  std::uint32_t* status = nullptr;
};

/// The places of points from number `first` on.
template <class Real>
WaveArrays<Real> partOf(const WaveArrays<Real>& all, std::size_t first) noexcept {
  const auto from = [=](auto* array) { return array ? array + first : nullptr; };
  return {from(all.height), from(all.slopeEast), from(all.slopeNorth), from(all.verticalVelocity),
          from(all.error),  from(all.bound),     from(all.status)};
}

/// Whether points of the sea plane can go from arrays to arrays in the field's cheapest form: there
/// is nothing but waves, and no orbital velocity is wanted.
bool isPlain(const SurfaceAtTime& water, const SampleOptions& options) noexcept;

/// Samples so where isPlain: the bits of SurfaceAtTime::sample, rounded to `Real`, and `common`
/// besides in each status. `x` and `y`: of n points, m, any values. Allocates nothing; only writes
/// to `out`.
template <class Real>
void sampleWaves(const SurfaceAtTime& water, std::span<const double> x, std::span<const double> y,
                 const SampleOptions& options, SampleStatus common,
                 const WaveArrays<Real>& out) noexcept;

/// The largest error and bound, m, that sampleWaves gives to any of the points; 0 where none is
/// served.
struct LargestFaults {
  double error = 0.0, bound = 0.0;
};
LargestFaults largestFaults(const SurfaceAtTime& water, std::span<const double> x,
                            std::span<const double> y, const SampleOptions& options) noexcept;

}  // namespace seaway::bridge
