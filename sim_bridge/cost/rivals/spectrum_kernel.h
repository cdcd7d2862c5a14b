#pragma once

#include <cstddef>

#include "sim_bridge/cost/rivals/fft_tile.h"

namespace seaway::rivals {

/// Coefficients of height, slopes and rate at time t, interleaved real and imaginary parts; plane
/// n starts at `out + 2 · n · count`. The spectrum's arrays are padded to a multiple of 16.
void advanceSpectrum(const TileSpectrum& spectrum, double t, std::size_t count, float* out);

}  // namespace seaway::rivals
