#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <limits>
#include <span>
#include <vector>

#include "surface/disturbance/analytic/rain.h"
#include "surface/disturbance/analytic/splash.h"
#include "surface/surface_sample.h"

namespace seaway {

/// What disturbs the water by formula: splashes and rain. A pure function of place and time.
///
/// Immutable. Const calls are thread-safe, allocate nothing and give the same bits for any batch.
class SurfaceEvents {
 public:
  struct Water {
    glm::dvec2 current{0.0};                                 ///< m/s: rings are carried along
    double depth = std::numeric_limits<double>::infinity();  ///< m
  };
  /// Of more splashes than this, InputError; and for any that cannot be (SplashRings).
  static constexpr std::size_t mostSplashes = 4096;
  SurfaceEvents(const std::vector<Splash>& splashes, const Rain& rain, const Water& water);

  bool empty() const { return splashes_.empty() && !rain_.falls(); }
  const Rain& rain() const { return rain_; }
  /// In order of their starts.
  std::span<const SplashRings> splashes() const { return splashes_; }
  /// Those that may be active at `t`: a part of `splashes`.
  std::span<const SplashRings> splashesAbout(double t) const noexcept;

  /// Adds heights, slopes, ∂η/∂t and orbital velocities at `points` and time `t` as far as
  /// `options` asks: splashes of at least the shortest wavelength wanted, rain where all is wanted.
  /// Water under a splash's rings moves as deep water does under waves that run outwards; under
  /// rain only up and down.
  void addTo(std::span<const glm::dvec2> points, double t, std::span<SurfaceSample> out,
             const SampleOptions& options) const noexcept;

  /// The splashes alone, as arrays of floats (see FieldAtTime::Arrays); spans that are empty are
  /// left out. Rings fade out as their wavelength falls from `kept` m to half of that.
  struct Arrays {
    std::span<float> height, slopeX, slopeY, rate;
  };
  void addSplashes(std::span<const double> x, std::span<const double> y, double t, double kept,
                   const Arrays& out) const noexcept;

  /// No |η| of the splashes active at `t` is above, m; rain adds Rain::ringHeight a drop.
  double heightBound(double t) const noexcept;

  std::size_t memoryBytes() const { return splashes_.capacity() * sizeof(SplashRings); }

 private:
  template <class PlaceOf, class Add>
  void forEachReached(std::size_t count, double t, const PlaceOf& place, const Add& add) const;

  std::vector<SplashRings> splashes_;
  Rain rain_;
  Water water_;
  double longest_ = 0.0;  // lifetime, s
};

}  // namespace seaway
