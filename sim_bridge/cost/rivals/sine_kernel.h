#pragma once

#include <span>

#include "sim_bridge/cost/rivals/sine_sum.h"

namespace seaway::rivals {

/// Adds up all components at points (m), points in lanes; every span of `out` is as long as `x`.
void sumSines(const SineSum::Prepared& components, std::span<const double> x,
              std::span<const double> y, const FieldAtTime::Arrays& out);

}  // namespace seaway::rivals
