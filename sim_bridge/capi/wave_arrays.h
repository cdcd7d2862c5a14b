#pragma once

#include <cstddef>

#include "sim_bridge/seaway.h"
#include "surface/water_surface.h"

namespace seaway::bridge::capi {

/// Whether points can go from the caller's arrays to the caller's arrays in the field's cheapest
/// form: nothing but waves in the sea plane, all points, no orbital velocity.
bool isPlain(const SurfaceAtTime& water, const seaway_points& points, const SampleOptions& options);

/// Samples points [first, end) so; the bits of SurfaceAtTime::sample.
void samplePlain(const SurfaceAtTime& water, const seaway_points& points, std::size_t first,
                 std::size_t end, const SampleOptions& options, const seaway_samples& out) noexcept;

}  // namespace seaway::bridge::capi
