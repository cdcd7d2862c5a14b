#pragma once

#include <limits>

namespace seaway {

/// Linear dispersion ω² = g k tanh(k d) and what follows from it. Depth in m, > 0 or infinite;
/// wave number k in rad/m, > 0; ω in rad/s, > 0. (Airy waves.)

inline constexpr double deepWater = std::numeric_limits<double>::infinity();

double angularFrequency(double waveNumber, double depth = deepWater);

/// Wave number of an angular frequency, to relative 1e-14, by Newton's method on the squared
/// equation from the deep- or shallow-water limit, whichever is larger.
double waveNumber(double angularFrequency, double depth = deepWater);

double phaseSpeed(double waveNumber, double depth = deepWater);  ///< ω/k, m/s
double groupSpeed(double waveNumber, double depth = deepWater);  ///< dω/dk, m/s

}  // namespace seaway
