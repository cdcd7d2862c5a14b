#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <limits>
#include <span>
#include <vector>

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

/// The waves: η(x, t) = Σᵢ ηᵢ(x, t), a pure function of seed, octaves, place and time.
///
/// Immutable after construction. Every member is thread-safe; `sample` neither allocates nor
/// locks, and gives the same bits for a point whatever batch it comes in. Octaves are kept by
/// falling standard deviation, so that a tolerance keeps a prefix of them.
class WaveField {
 public:
  /// Throws InputError for an octave or setting outside the ranges stated beside it.
  explicit WaveField(std::vector<Octave> octaves, const WaveFieldSettings& settings = {});

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

  /// No height exceeds ± this, m: the smaller of 5.5 standard deviations (passed by fewer than one
  /// height in 10⁷ of a Gaussian sea) and the sum of the octaves' own bounds.
  double heightBound() const { return heightBound_; }

  /// Heights, slopes, ∂η/∂t, error, bound and status at `points` (m, sea plane) and time `t` (s
  /// since the scene's epoch). `out` has at least the size of `points`. A point that is not finite
  /// gets NaN and `notFinite`; the others are unharmed.
  ///
  /// Double precision throughout; `bound` covers its rounding, which grows with |x| and |t|.
  void sample(std::span<const glm::dvec2> points, double t, std::span<SurfaceSample> out,
              const SampleOptions& options = {}) const noexcept;

  std::size_t memoryBytes() const;

 private:
  std::vector<Octave> octaves_;
  std::vector<PerlinOctave> evaluators_;  // one an octave, same order
  std::vector<double> leftOut_;  // [kept] = √Σ of the rest; one more than octaves
  WaveFieldSettings settings_;
  double heightBound_ = 0.0;
};

}  // namespace seaway
