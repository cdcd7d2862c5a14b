#pragma once

#include <glm/vec2.hpp>
#include <span>

#include "surface/water_surface.h"

namespace seaway {

/// SurfaceAtTime::sample on several threads, for large batches: below some 10 000 points one thread
/// is as quick. The same bits for any number of threads.
///
/// Runs in the caller's oneTBB task arena: by default one that all callers share, with as many
/// threads as the machine has cores, started by the first call. Allocates. Thread-safe.
void sampleInParallel(const SurfaceAtTime& water, std::span<const glm::dvec2> points,
                      std::span<SurfaceSample> out, const SampleOptions& options = {});

/// The same in the field's cheapest form: see FieldAtTime::Arrays.
void sampleInParallel(const FieldAtTime& waves, std::span<const double> x,
                      std::span<const double> y, const FieldAtTime::Arrays& out,
                      const SampleOptions& options = {});

}  // namespace seaway
