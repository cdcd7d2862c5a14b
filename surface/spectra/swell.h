#pragma once

#include <cstddef>

#include "surface/spectra/frequency_spectrum.h"

namespace seaway {

/// Swell as a Gaussian in frequency: S(f) = (H_m0/4)²/(w√(2π)) exp(−(f − 1/T_p)²/(2w²)), on `count`
/// uniform frequencies within 5 widths of the peak (above 0), scaled there to the H_m0 asked for.
/// The Gaussian swell of offshore practice (ISO 19901-1, DNV-OS-E301), w about 0.005–0.015 Hz.
///
/// H_m0 in m and T_p in s, both > 0; width w in Hz, in (0, 0.5/T_p], where less than 2.3 % of the
/// bell is lost below 0. Throws InputError for anything else.
FrequencySpectrum gaussianSwell(double significantWaveHeight, double peakPeriod, double width,
                                std::size_t count = 600);

}  // namespace seaway
