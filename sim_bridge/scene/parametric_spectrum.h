#pragma once

#include <functional>

#include "sim_bridge/scene/scene.h"
#include "surface/field/octave.h"
#include "surface/spectra/frequency_spectrum.h"

namespace seaway::bridge {

/// The spectrum that a parametric state asks for in water of a depth (m, > 0 or infinite). Throws
/// InputError for parameters that the family does not allow.
FrequencySpectrum spectrumOf(const ParametricState& state, double depth);

/// The exponent s of cos²ˢ spreading that the state asks for at an octave of its fit, in water of
/// that depth; not below 0.5.
std::function<double(const Octave&)> exponentsOf(const ParametricState& state,
                                                 const FrequencySpectrum& spectrum, double depth);

}  // namespace seaway::bridge
