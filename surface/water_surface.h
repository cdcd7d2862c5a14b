#pragma once

#include <glm/vec2.hpp>
#include <span>

#include "surface/field/wave_field.h"
#include "surface/surface_sample.h"

namespace seaway {

/// The one surface that physics asks and pictures draw: waves now, disturbances as they come.
///
/// Heights are metres above the still-water level, points are metres of the sea plane, times are
/// seconds since the scene's epoch. Const calls are thread-safe, allocate nothing and do not
/// depend on who asks or in what order.
class WaterSurface {
 public:
  explicit WaterSurface(WaveField waves) : waves_(std::move(waves)) {}

  const WaveField& waves() const { return waves_; }

  /// See WaveField::sample.
  void sample(std::span<const glm::dvec2> points, double t, std::span<SurfaceSample> out,
              const SampleOptions& options = {}) const noexcept {
    waves_.sample(points, t, out, options);
  }

  SurfaceSample sample(glm::dvec2 point, double t, const SampleOptions& options = {}) const noexcept {
    SurfaceSample result;
    sample(std::span(&point, 1), t, std::span(&result, 1), options);
    return result;
  }

  /// See WaveField::heightBound.
  double heightBound() const { return waves_.heightBound(); }

 private:
  WaveField waves_;
};

}  // namespace seaway
