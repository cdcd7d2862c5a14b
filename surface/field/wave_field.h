#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <span>
#include <vector>

#include "surface/field/field_section.h"
#include "surface/field/group_octave.h"
#include "surface/field/octave.h"
#include "surface/field/perlin_octave.h"
#include "surface/surface_sample.h"

namespace seaway {

/// What the octaves of a field share.
struct WaveFieldSettings {
  std::uint64_t seed = 1;
  double depth = std::numeric_limits<double>::infinity();  ///< m, > 0
  glm::dvec2 current{0.0};  ///< uniform current, m/s (east, north): carries the waves along
};

class FieldAtTime;
class Tile;

/// The waves: η(x, t) = Σᵢ ηᵢ(x, t), a pure function of seed, octaves, place and time.
///
/// Immutable after construction. Every member is thread-safe; `sample` neither allocates nor
/// locks, and gives the same bits for a point whatever batch it comes in and whichever call asks.
/// Octaves are kept by falling standard deviation, so that a tolerance keeps a prefix of them.
class WaveField {
 public:
  /// Throws InputError for an octave or setting outside the ranges stated beside it.
  explicit WaveField(std::vector<Octave> octaves, const WaveFieldSettings& settings = {});

  static constexpr double farthest = 1e12;  ///< m, along each axis of the sea plane
  static constexpr double latest = 1e12;    ///< s, either side of the epoch

  /// Whether place and time are finite and within those.
  static bool serves(glm::dvec2 point, double t) {
    return std::abs(point.x) <= farthest && std::abs(point.y) <= farthest && std::abs(t) <= latest;
  }

  std::span<const Octave> octaves() const { return octaves_; }
  const WaveFieldSettings& settings() const { return settings_; }

  /// √Σaᵢ², m.
  double standardDeviation() const { return leftOut_.front(); }
  /// H_m0 = 4√Σaᵢ², m.
  double significantWaveHeight() const { return 4.0 * standardDeviation(); }

  /// Number of leading octaves whose remainder has a standard deviation of at most `tolerance` m.
  std::size_t octavesFor(double tolerance) const;
  /// Standard deviation of all octaves after the first `kept`, m.
  double leftOut(std::size_t kept) const { return leftOut_[kept]; }

  /// Heights stay within ± this, m, but for fewer than one in 10⁷: the smaller of 5.5 standard
  /// deviations of a Gaussian sea and the sum of the octaves' own bounds, which nothing passes.
  double heightBound() const { return heightBound_; }

  /// Heights, slopes, ∂η/∂t, error, bound and status at `points` (m, sea plane) and time `t` (s
  /// since the scene's epoch). `out` has at least the size of `points`. A point that is not finite
  /// gets NaN and `notFinite`, one beyond `farthest` or a time beyond `latest` NaN and
  /// `outOfRange`; the others are unharmed. A tolerance that is not above 0 asks for everything.
  ///
  /// Coordinates are reduced in double, the rest is float in vectors of points: `bound` covers
  /// both (tests/surface/field_kernels_test.cpp). Many queries of few points at one time are
  /// cheaper through `at`.
  void sample(std::span<const glm::dvec2> points, double t, std::span<SurfaceSample> out,
              const SampleOptions& options = {}) const noexcept;

  /// The field prepared for one time.
  FieldAtTime at(double t) const;

  /// The same field in double precision throughout, octave by octave as the equations read: the
  /// truth that `sample` is tested against, some ten times slower. `bound` covers its own rounding.
  void sampleReference(std::span<const glm::dvec2> points, double t, std::span<SurfaceSample> out,
                       const SampleOptions& options = {}) const noexcept;

  /// Largest numerical error of a height from `sample` at distance |point| ≤ `reach` m, m.
  double bound(double reach) const noexcept;

  /// The octaves' reference evaluators by kind, each in order of falling standard deviation.
  OctaveLists lists() const { return {groups_, perlins_, regulars_, settings_.current}; }

  std::size_t memoryBytes() const;

 private:
  friend class FieldAtTime;

  /// What some options leave of the field, and what every valid sample says of it.
  struct Selection {
    KeptOctaves kept;
    double error = 0.0;  // standard deviation left out, m
    SampleStatus status = SampleStatus::ok;
    Quantities what = Quantities::surface;
  };
  Selection select(const SampleOptions& options) const noexcept;
  SurfaceSample blank(glm::dvec2 point, double t, const Selection& selection) const noexcept;
  void finish(std::span<const glm::dvec2> points, double t, const Selection& selection,
              const Tile& tile, std::span<SurfaceSample> out) const noexcept;

  std::vector<Octave> octaves_;
  std::vector<GroupOctave> groups_, regulars_;  // in the order of octaves_
  std::vector<PerlinOctave> perlins_;
  std::vector<KeptOctaves> keptByKind_;  // [kept]: how many of each kind are among them
  std::vector<double> leftOut_;          // [kept] = √Σ of the rest; one more than octaves
  WaveFieldSettings settings_;
  double heightBound_ = 0.0;
  double floatBound_ = 0.0;     // m: rounding of the kernels in float
  double boundPerMetre_ = 0.0;  // rounding of the coordinates in double, per metre of reach
};

/// A wave field at one time: what depends on the time alone is worked out once. Refers to the
/// field, which must outlive it. Const calls are thread-safe, allocate nothing and give the bits
/// that WaveField::sample gives.
class FieldAtTime {
 public:
  FieldAtTime(const WaveField& field, double t);

  /// Prepares this object for another time, or field, anew; allocates only for a field with more
  /// octaves. Not while others sample.
  void moveTo(const WaveField& field, double t);

  double time() const { return time_; }
  void sample(std::span<const glm::dvec2> points, std::span<SurfaceSample> out,
              const SampleOptions& options = {}) const noexcept;
  SurfaceSample sample(glm::dvec2 point, const SampleOptions& options = {}) const noexcept;

  /// The same values as arrays of floats, the cheapest form: `x` and `y` of n points, n elements in
  /// each span that is not empty; where all but the height are, they are not computed. Points that
  /// are not finite give NaN.
  struct Arrays {
    std::span<float> height, slopeX, slopeY, rate;
  };
  void sample(std::span<const double> x, std::span<const double> y, const Arrays& out,
              const SampleOptions& options = {}) const noexcept;

  /// Dynamic pressure head Σ ηᵢ cosh k(z' + d)/cosh kd, m, and motion of the water at stretched
  /// heights z' ≤ 0 (m; see sampleKinematics, which is the call to use): `x`, `y` and `stretched`
  /// of n ≤ pointsPerTile points. Where `out` has no velocity only the pressure is computed.
  /// Octaves without kinematics add nothing.
  struct Motion {
    std::span<float> head;
    std::span<glm::vec3> velocity, acceleration;  ///< m/s, m/s²
  };
  void sampleBelow(std::span<const glm::dvec2> points, std::span<const float> stretched,
                   const Motion& out, const SampleOptions& options = {}) const noexcept;

  const WaveField& field() const { return *field_; }

 private:
  const WaveField* field_;
  double time_;
  std::vector<FieldSection> sections_;
};

}  // namespace seaway
