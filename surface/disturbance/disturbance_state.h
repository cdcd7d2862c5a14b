#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "surface/disturbance/wake_grid.h"
#include "surface/surface_sample.h"

namespace seaway {

/// One wake window's surface between two of its steps.
struct WakeSheet {
  std::shared_ptr<const WakeGrid> before, after;
  double start = 0.0, end = 0.0;  ///< times of the two, s
  double cellSize = 0.5;          ///< m
  glm::dvec2 centre{0.0};         ///< of the window, m, in the water's frame

  double size() const { return cellSize * before->cells; }  ///< m
  /// Waves are whole within this distance of the centre along each axis; beyond, the border takes
  /// them away, m.
  double interior() const { return 0.35 * size(); }
};

/// One vessel's waves: sheets of different wavelengths, whose heights add up.
struct VesselWaves {
  std::uint32_t vessel = 0;       ///< handle, for SampleOptions::excludeVessel
  std::vector<WakeSheet> sheets;  ///< from the shortest waves to the longest
  double meanWaveNumber = 0.0;    ///< by energy, rad/m: how fast the motion decays with depth
};

/// Where the water is in motion for other reasons than the sea state, at times in [start, end].
///
/// Immutable: readers hold it by shared_ptr while the next one is made. Const calls are
/// thread-safe, allocate nothing and give the same bits for any batch. A time outside the interval
/// is answered with the nearest end's surface and the status `wakeOutOfTime`.
class DisturbanceState {
 public:
  struct Water {
    glm::dvec2 current{0.0};                                 ///< m/s: waves are carried along
    double depth = std::numeric_limits<double>::infinity();  ///< m
  };
  DisturbanceState(std::vector<VesselWaves> wakes, const Water& water);

  bool empty() const { return wakes_.empty(); }
  double start() const { return start_; }
  double end() const { return end_; }
  std::span<const VesselWaves> wakes() const { return wakes_; }
  /// How far the water has been carried since the epoch, m: windows lie in its frame.
  glm::dvec2 drift(double t) const { return water_.current * t; }

  /// Adds heights, slopes, ∂η/∂t and orbital velocities at `points` (sea plane, m) and time `t` to
  /// `out`, as far as `options` asks; cubic B-splines in space and cubic Hermite in time, within
  /// 0.5 % of the wake's height, which `bound` grows by, and 1 % of its slope. Some 10 ns a point
  /// and sheet (tests/bench/wake_bench.cpp).
  void addTo(std::span<const glm::dvec2> points, double t, std::span<SurfaceSample> out,
             const SampleOptions& options) const noexcept;

  /// The same as arrays; see FieldAtTime::Arrays. Spans that are empty are left out.
  struct Arrays {
    std::span<float> height, slopeX, slopeY, rate;
  };
  void addTo(std::span<const double> x, std::span<const double> y, double t, const Arrays& out,
             const SampleOptions& options) const noexcept;

  /// What motion below the surface is made of at one point: the waves of one vessel there.
  struct Motion {
    float height = 0.0f, rate = 0.0f;  ///< η, m; ∂η/∂t in the water's frame, m/s
    glm::vec2 slope{0.0f};
    glm::vec2 velocity{0.0f};  ///< at the surface, m/s
    bool hasVelocity = false;
  };
  Motion motion(const VesselWaves& wake, glm::dvec2 point, double t) const noexcept;

  /// No |η| of the disturbances is above, m.
  double heightBound() const { return heightBound_; }

  std::size_t memoryBytes() const;

 private:
  std::vector<VesselWaves> wakes_;
  Water water_;
  double start_ = -std::numeric_limits<double>::infinity();
  double end_ = std::numeric_limits<double>::infinity();
  double heightBound_ = 0.0;
};

}  // namespace seaway
