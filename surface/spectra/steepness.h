#pragma once

#include <span>

#include "surface/field/octave.h"

/// How steep a sea is, and how steep seas get before they break.
namespace seaway {

/// T_m02 of the octaves' own waves in s, each taken at its dominant wavelength; `depth` m, > 0 or
/// infinite. NaN without energy.
double meanPeriod(std::span<const Octave> octaves, double depth);

/// S_s = 2π H_m0 / (g T_m02²). `hm0` m, `tm02` s > 0.
double averageSteepness(double hm0, double tm02);

/// The largest average steepness that seas reach: 1/10 up to T_m02 of 6 s, 1/15 from 12 s, linear
/// between (DNV-RP-C205, section 3.5.4).
double limitingSteepness(double tm02);

}  // namespace seaway
