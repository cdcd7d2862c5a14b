#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "surface/field/wave_field.h"

namespace seaway::bridge::rpc {

/// An octave as the sine wave that it is about a place and a time:
/// η = amplitude · sin(k (x cos ψ + y sin ψ) − ωt + phase), in xdyn's frame, η upwards.
struct LocalWave {
  double amplitude = 0.0;   ///< m, of the envelope there and then
  double waveNumber = 0.0;  ///< rad/m
  double frequency = 0.0;   ///< ω as a fixed point sees it, the current included, rad/s
  double direction = 0.0;   ///< ψ, rad
  double phase = 0.0;       ///< rad, in (−π, π]
};

/// The octaves of a field at `point` (sea plane, m) and `t`, by falling standard deviation. Their
/// sum is the field's height there and then to 1e-9 of its standard deviation, and nearby as long
/// as the envelopes hold. Throws InputError for a field with Perlin octaves, which are no waves of
/// one length.
std::vector<LocalWave> localWaves(const WaveField& waves, glm::dvec2 point, double t);

}  // namespace seaway::bridge::rpc
