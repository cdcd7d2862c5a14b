#pragma once

#include <glm/vec2.hpp>
#include <memory>
#include <span>
#include <utility>

#include "surface/disturbance/analytic/surface_events.h"
#include "surface/disturbance/disturbance_state.h"
#include "surface/disturbance/published.h"
#include "surface/disturbance/surface_detail.h"
#include "surface/field/wave_field.h"
#include "surface/outline/water_outline.h"
#include "surface/surface_sample.h"

namespace seaway {

/// What disturbs a sea, as WakeSystem publishes it.
using DisturbanceFeed = Published<DisturbanceState>;

class WaterSurface;

/// What disturbs a sea beside wakes: by formula, and as pictures of the surface about a time. Null:
/// nothing.
struct SurfaceExtras {
  std::shared_ptr<const SurfaceEvents> events;  ///< splashes, rain
  std::shared_ptr<const SurfaceDetail> detail;  ///< foam, smoothed water, oil, pools of ripples

  /// Adds to samples of waves (and wakes) what disturbs them; `sampleWaves` as dampShortWaves.
  template <class SampleWaves>
  void addTo(std::span<const glm::dvec2> points, double t, std::span<SurfaceSample> out,
             const SampleOptions& options, const SampleWaves& sampleWaves) const noexcept {
    if (detail) {
      dampShortWaves(*detail, points, t, out, options, sampleWaves);
      for (const auto& sheet : detail->ripples) sheet->addTo(points, t, out, options);
    }
    if (events) events->addTo(points, t, out, options);
  }
  double heightBound(double t) const {
    return (events ? events->heightBound(t) : 0.0) + (detail ? detail->heightBound() : 0.0);
  }
};

/// The water surface prepared for one time: what to ask for many queries of few points at that
/// time. Refers to the surface it comes from, which must outlive it, and holds the disturbances of
/// the moment it was made. Const calls are thread-safe and allocate nothing.
class SurfaceAtTime {
 public:
  explicit SurfaceAtTime(FieldAtTime waves,
                         std::shared_ptr<const DisturbanceState> disturbances = nullptr,
                         const WaterOutline* outline = nullptr, SurfaceExtras extras = {})
      : waves_(std::move(waves)),
        disturbances_(std::move(disturbances)),
        outline_(outline),
        extras_(std::move(extras)) {}

  /// Prepares this object for `surface` at another time, with the disturbances of now: as
  /// WaterSurface::at, but allocates only for a field with more octaves. Not while others sample.
  void moveTo(const WaterSurface& surface, double t);

  double time() const { return waves_.time(); }
  const FieldAtTime& waves() const { return waves_; }
  /// Null where nothing disturbs the waves.
  const DisturbanceState* disturbances() const { return disturbances_.get(); }
  /// Null where there is water everywhere.
  const WaterOutline* outline() const { return outline_; }
  const SurfaceExtras& extras() const { return extras_; }

  /// See WaveField::sample; the same bits. Outside the outline: NaN, SampleStatus::dry.
  void sample(std::span<const glm::dvec2> points, std::span<SurfaceSample> out,
              const SampleOptions& options = {}) const noexcept {
    waves_.sample(points, out, options);
    addExtras(points, out, options);
    if (disturbances_) disturbances_->addTo(points, time(), out, options);
    if (outline_) outline_->markDry(points, out);
  }
  SurfaceSample sample(glm::dvec2 point, const SampleOptions& options = {}) const noexcept {
    SurfaceSample result = waves_.sample(point, options);
    const std::span<const glm::dvec2> points(&point, 1);
    addExtras(points, std::span(&result, 1), options);
    if (disturbances_) disturbances_->addTo(points, time(), std::span(&result, 1), options);
    if (outline_) outline_->markDry(points, std::span(&result, 1));
    return result;
  }

  /// See FieldAtTime::Arrays: waves and wakes alone; the outline is not looked at.
  void sample(std::span<const double> x, std::span<const double> y, const FieldAtTime::Arrays& out,
              const SampleOptions& options = {}) const noexcept {
    waves_.sample(x, y, out, options);
    if (disturbances_) {
      disturbances_->addTo(x, y, time(), {out.height, out.slopeX, out.slopeY, out.rate}, options);
    }
  }

  /// See WaveField::heightBound; disturbances included.
  double heightBound() const {
    return waves_.field().heightBound() + (disturbances_ ? disturbances_->heightBound() : 0.0) +
           extras_.heightBound(time());
  }

 private:
  void addExtras(std::span<const glm::dvec2> points, std::span<SurfaceSample> out,
                 const SampleOptions& options) const noexcept {
    if (!extras_.events && !extras_.detail) return;
    extras_.addTo(points, time(), out, options,
                  [&](auto some, auto samples, const SampleOptions& wanted) {
                    waves_.sample(some, samples, wanted);
                  });
  }

  FieldAtTime waves_;
  std::shared_ptr<const DisturbanceState> disturbances_;
  const WaterOutline* outline_;
  SurfaceExtras extras_;
};

/// The one surface that physics asks and pictures draw: waves, and what disturbs them.
///
/// Heights are metres above the still-water level, points are metres of the sea plane, times are
/// seconds since the scene's epoch. Const calls are thread-safe, allocate nothing and do not
/// depend on who asks or in what order; with disturbances they see those published last.
class WaterSurface {
 public:
  explicit WaterSurface(WaveField waves) : waves_(std::move(waves)) {}

  const WaveField& waves() const { return waves_; }

  /// Adds what `feed` publishes to the waves from now on (WakeSystem::feed); null: nothing. Not
  /// while others sample.
  void setDisturbances(std::shared_ptr<const DisturbanceFeed> feed) { feed_ = std::move(feed); }
  /// Published last; null where nothing disturbs the waves.
  std::shared_ptr<const DisturbanceState> disturbances() const noexcept {
    return feed_ ? feed_->latest() : nullptr;
  }

  /// Water only within `outline` from now on; null: everywhere. Not while others sample.
  void setOutline(std::shared_ptr<const WaterOutline> outline) { outline_ = std::move(outline); }
  /// Null where there is water everywhere.
  const WaterOutline* outline() const { return outline_.get(); }
  std::shared_ptr<const WaterOutline> sharedOutline() const { return outline_; }

  /// Splashes, rain, layers and ripples from now on. Not while others sample.
  void setEvents(std::shared_ptr<const SurfaceEvents> events) {
    extras_.events = std::move(events);
  }
  void setDetail(std::shared_ptr<const SurfaceDetail> detail) {
    extras_.detail = std::move(detail);
  }
  const SurfaceExtras& extras() const { return extras_; }

  /// The surface prepared for one time; allocates.
  SurfaceAtTime at(double t) const {
    return SurfaceAtTime(waves_.at(t), disturbances(), outline(), extras_);
  }

  /// See WaveField::sample. Outside the outline: NaN, SampleStatus::dry.
  void sample(std::span<const glm::dvec2> points, double t, std::span<SurfaceSample> out,
              const SampleOptions& options = {}) const noexcept {
    sampleWithoutWakes(points, t, out, options);
    if (feed_) {
      if (const auto state = feed_->latest()) state->addTo(points, t, out, options);
    }
    if (outline_) outline_->markDry(points, out);
  }

  /// The same without what the feed publishes, and without the outline.
  void sampleWithoutWakes(std::span<const glm::dvec2> points, double t,
                          std::span<SurfaceSample> out,
                          const SampleOptions& options = {}) const noexcept {
    waves_.sample(points, t, out, options);
    if (!extras_.events && !extras_.detail) return;
    extras_.addTo(points, t, out, options,
                  [&](auto some, auto samples, const SampleOptions& wanted) {
                    waves_.sample(some, t, samples, wanted);
                  });
  }

  SurfaceSample sample(glm::dvec2 point, double t,
                       const SampleOptions& options = {}) const noexcept {
    SurfaceSample result;
    sample(std::span(&point, 1), t, std::span(&result, 1), options);
    return result;
  }

  /// See WaveField::heightBound; disturbances included, but for splashes and rain.
  double heightBound() const {
    const auto state = disturbances();
    return waves_.heightBound() + (state ? state->heightBound() : 0.0) +
           (extras_.detail ? extras_.detail->heightBound() : 0.0);
  }
  /// The same at time `t` with splashes and rain.
  double heightBound(double t) const {
    return heightBound() + (extras_.events ? extras_.events->heightBound(t) : 0.0);
  }

 private:
  WaveField waves_;
  std::shared_ptr<const DisturbanceFeed> feed_;
  std::shared_ptr<const WaterOutline> outline_;
  SurfaceExtras extras_;
};

inline void SurfaceAtTime::moveTo(const WaterSurface& surface, double t) {
  waves_.moveTo(surface.waves(), t);
  disturbances_ = surface.disturbances();
  outline_ = surface.outline();
  extras_ = surface.extras();
}

}  // namespace seaway
