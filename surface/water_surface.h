#pragma once

#include <glm/vec2.hpp>
#include <memory>
#include <span>
#include <utility>

#include "surface/field/wave_field.h"
#include "surface/outline/water_outline.h"
#include "surface/surface_sample.h"

namespace seaway {

/// The water surface prepared for one time: what to ask for many queries of few points at that time.
/// Refers to the surface it comes from, which must outlive it. Const calls are thread-safe and
/// allocate nothing.
class SurfaceAtTime {
 public:
  explicit SurfaceAtTime(FieldAtTime waves, const WaterOutline* outline = nullptr)
      : waves_(std::move(waves)), outline_(outline) {}

  double time() const { return waves_.time(); }
  const FieldAtTime& waves() const { return waves_; }
  /// Null where there is water everywhere.
  const WaterOutline* outline() const { return outline_; }

  /// See WaveField::sample; the same bits. Outside the outline: NaN, SampleStatus::dry.
  void sample(std::span<const glm::dvec2> points, std::span<SurfaceSample> out,
              const SampleOptions& options = {}) const noexcept {
    waves_.sample(points, out, options);
    if (outline_) outline_->markDry(points, out);
  }
  SurfaceSample sample(glm::dvec2 point, const SampleOptions& options = {}) const noexcept {
    SurfaceSample result = waves_.sample(point, options);
    if (outline_) outline_->markDry(std::span(&point, 1), std::span(&result, 1));
    return result;
  }

  /// See WaveField::heightBound.
  double heightBound() const { return waves_.field().heightBound(); }

 private:
  FieldAtTime waves_;
  const WaterOutline* outline_;
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

  /// Water only within `outline` from now on; null: everywhere. Not while others sample.
  void setOutline(std::shared_ptr<const WaterOutline> outline) { outline_ = std::move(outline); }
  /// Null where there is water everywhere.
  const WaterOutline* outline() const { return outline_.get(); }
  std::shared_ptr<const WaterOutline> sharedOutline() const { return outline_; }

  /// The surface prepared for one time; allocates.
  SurfaceAtTime at(double t) const { return SurfaceAtTime(waves_.at(t), outline()); }

  /// See WaveField::sample. Outside the outline: NaN, SampleStatus::dry.
  void sample(std::span<const glm::dvec2> points, double t, std::span<SurfaceSample> out,
              const SampleOptions& options = {}) const noexcept {
    waves_.sample(points, t, out, options);
    if (outline_) outline_->markDry(points, out);
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
  std::shared_ptr<const WaterOutline> outline_;
};

}  // namespace seaway
