#pragma once

#include <span>

#include "tests/bench/rivals/sine_sum.h"

namespace seaway::bench {

/// Adds up all components at points (m), points in lanes; every span of `out` is as long as `x`.
void sumSines(const SineSum::Prepared& components, std::span<const double> x,
              std::span<const double> y, const FieldAtTime::Arrays& out);

}  // namespace seaway::bench
