#pragma once

#include <cmath>
#include <glm/vec2.hpp>
#include <limits>
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
#include "surface/terrain/terrain_map.h"

namespace seaway {

/// What disturbs a sea, as WakeSystem publishes it.
using DisturbanceFeed = Published<DisturbanceState>;

class WaterSurface;

/// See WaterSurface::bedAt.
inline double bedHeight(const TerrainMap* terrain, const WaveField& waves,
                        glm::dvec2 point) noexcept {
  const double ground =
      terrain ? terrain->heightAt(point) : -std::numeric_limits<double>::infinity();
  return std::isinf(ground) ? -waves.settings().depth : ground;
}

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
                         const WaterOutline* outline = nullptr, SurfaceExtras extras = {},
                         const TerrainMap* terrain = nullptr)
      : waves_(std::move(waves)),
        disturbances_(std::move(disturbances)),
        outline_(outline),
        terrain_(terrain),
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
  /// Null where no map tells the sea bed.
  const TerrainMap* terrain() const { return terrain_; }
  const SurfaceExtras& extras() const { return extras_; }

  /// Height of the sea bed or the ground above the still-water level, m; see WaterSurface::bedAt.
  double bedAt(glm::dvec2 point) const noexcept {
    return bedHeight(terrain_, waves_.field(), point);
  }

  /// See WaveField::sample; the same bits. Outside the outline, and where the terrain stands above
  /// the water: NaN, SampleStatus::dry.
  void sample(std::span<const glm::dvec2> points, std::span<SurfaceSample> out,
              const SampleOptions& options = {}) const noexcept {
    waves_.sample(points, out, options);
    addExtras(points, out, options);
    if (disturbances_) disturbances_->addTo(points, time(), out, options);
    if (outline_) outline_->markDry(points, out);
    if (terrain_) terrain_->markDry(points, out);
  }
  SurfaceSample sample(glm::dvec2 point, const SampleOptions& options = {}) const noexcept {
    SurfaceSample result = waves_.sample(point, options);
    const std::span<const glm::dvec2> points(&point, 1);
    addExtras(points, std::span(&result, 1), options);
    if (disturbances_) disturbances_->addTo(points, time(), std::span(&result, 1), options);
    if (outline_) outline_->markDry(points, std::span(&result, 1));
    if (terrain_) terrain_->markDry(points, std::span(&result, 1));
    return result;
  }

  /// See FieldAtTime::Arrays: waves and wakes alone; outline and terrain are not looked at.
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
  const TerrainMap* terrain_;
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

  /// Ground and sea bed from now on; null: no ground but an outline's, a bed at the field's depth.
  /// Where both are given both apply: water is inside the outline and above the terrain. Not while
  /// others sample.
  void setTerrain(std::shared_ptr<const TerrainMap> terrain) { terrain_ = std::move(terrain); }
  /// Null where no map tells the sea bed.
  const TerrainMap* terrain() const { return terrain_.get(); }
  std::shared_ptr<const TerrainMap> sharedTerrain() const { return terrain_; }

  /// Height of the sea bed or the ground above the still-water level, m: the terrain's on its map,
  /// the field's depth beyond (−∞ in deep water). The water column at a point is the sample's
  /// height less this.
  double bedAt(glm::dvec2 point) const noexcept { return bedHeight(terrain_.get(), waves_, point); }

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
    return SurfaceAtTime(waves_.at(t), disturbances(), outline(), extras_, terrain());
  }

  /// See WaveField::sample. Outside the outline, and where the terrain stands above the water: NaN,
  /// SampleStatus::dry.
  void sample(std::span<const glm::dvec2> points, double t, std::span<SurfaceSample> out,
              const SampleOptions& options = {}) const noexcept {
    sampleWithoutWakes(points, t, out, options);
    if (feed_) {
      if (const auto state = feed_->latest()) state->addTo(points, t, out, options);
    }
    if (outline_) outline_->markDry(points, out);
    if (terrain_) terrain_->markDry(points, out);
  }

  /// The same without what the feed publishes, without the outline and the terrain.
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
  std::shared_ptr<const TerrainMap> terrain_;
  SurfaceExtras extras_;
};

inline void SurfaceAtTime::moveTo(const WaterSurface& surface, double t) {
  waves_.moveTo(surface.waves(), t);
  disturbances_ = surface.disturbances();
  outline_ = surface.outline();
  terrain_ = surface.terrain();
  extras_ = surface.extras();
}

}  // namespace seaway
