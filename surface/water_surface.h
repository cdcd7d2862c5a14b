#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <utility>

#include "surface/field/wave_field.h"
#include "surface/surface_sample.h"

namespace seaway {

/// The water surface prepared for one time: what to ask for many queries of few points at that time.
/// Refers to the surface it comes from, which must outlive it. Const calls are thread-safe and
/// allocate nothing.
class SurfaceAtTime {
 public:
  explicit SurfaceAtTime(FieldAtTime waves) : waves_(std::move(waves)) {}

  double time() const { return waves_.time(); }
  const FieldAtTime& waves() const { return waves_; }

  /// See WaveField::sample; the same bits.
  void sample(std::span<const glm::dvec2> points, std::span<SurfaceSample> out,
              const SampleOptions& options = {}) const noexcept {
    waves_.sample(points, out, options);
  }
  SurfaceSample sample(glm::dvec2 point, const SampleOptions& options = {}) const noexcept {
    return waves_.sample(point, options);
  }

  /// See WaveField::heightBound.
  double heightBound() const { return waves_.field().heightBound(); }

 private:
  FieldAtTime waves_;
};

/// The one surface that physics asks and pictures draw: waves now, disturbances as they come.
///
/// Heights are metres above the still-water level, points are metres of the sea plane, times are
/// seconds since the scene's epoch. Const calls are thread-safe, allocate nothing and do not
/// depend on who asks or in what order.
class WaterSurface {
 public:
  explicit WaterSurface(WaveField waves) : waves_(std::move(waves)) {}

  const WaveField& waves() const { return waves_; }

  /// The surface prepared for one time; allocates.
  SurfaceAtTime at(double t) const { return SurfaceAtTime(waves_.at(t)); }

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
